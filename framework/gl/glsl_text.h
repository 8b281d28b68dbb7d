// What a GLSL text defines, without a compiler: its tokens, functions and structs. Preprocessor lines are passed over,
// so both branches of an #if count. Needs no GL.
#pragma once

#include <string>
#include <vector>

namespace relief {

/// A piece of the text, from `begin` to before `end`; comments and preprocessor lines are none.
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
    int count = 0;  ///< elements of an array; 0: it is none
};

struct GlslFunction {
    std::string type, name;
    std::vector<GlslVariable> parameters;
    size_t begin = 0;    ///< of its return type, or of what qualifies that
    size_t name_at = 0;  ///< of its name
    size_t end = 0;      ///< behind its closing brace

    /// "over(vec3,float)": overloads differ in it.
    std::string signature() const;
    /// Whether it returns all that it computes.
    bool has_result_only() const;
};

struct GlslStruct {
    std::string name;
    std::vector<GlslVariable> fields;
    size_t begin = 0, end = 0;  ///< behind its semicolon
};

struct GlslText {
    std::vector<GlslFunction> functions;  ///< those with a body, in the text's order
    std::vector<GlslStruct> structs;
};

/// What cannot be read as a function or a struct is passed over: a compiler says more about it.
GlslText parse_glsl(const std::string& text);

}  // namespace relief
