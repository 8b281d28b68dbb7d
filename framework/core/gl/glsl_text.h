// Tokens, functions and structs of a GLSL text, found without a compiler. Preprocessor lines are ignored, so both
// branches of an #if count. Needs no GL.
#pragma once

#include <string>
#include <vector>

namespace relief {

/// A token: the half-open range [begin, end) of the text. Comments and preprocessor lines yield no tokens.
struct GlslToken {
    enum Kind { word, number, symbol };
    Kind kind;
    size_t begin, end;
    std::string text;  ///< a symbol is one character
};
std::vector<GlslToken> glsl_tokens(const std::string& text);

/// A parameter of a function, or a field of a struct.
struct GlslVariable {
    std::string qualifier;  ///< "in", "out" or "inout"
    std::string type, name;
    int count = 0;  ///< array size; 0 if it is not an array
};

struct GlslFunction {
    std::string type, name;
    std::vector<GlslVariable> parameters;
    size_t begin = 0;    ///< offset of the return type or of its first qualifier
    size_t name_at = 0;  ///< offset of the name
    size_t end = 0;      ///< offset after the closing brace

    /// Returns a key that differs between overloads, such as "over(vec3,float)".
    std::string signature() const;
    /// Returns whether the return value is the function's only output: not void, and no `out` or `inout` parameters.
    bool has_result_only() const;
};

struct GlslStruct {
    std::string name;
    std::vector<GlslVariable> fields;
    size_t begin = 0, end = 0;  ///< `end` is after the semicolon
};

struct GlslText {
    std::vector<GlslFunction> functions;  ///< definitions with a body, in the text's order
    std::vector<GlslStruct> structs;
};

/// Parses the text. Skips everything that is not a well-formed function or struct: error messages are the compiler's
/// work.
GlslText parse_glsl(const std::string& text);

}  // namespace relief
