// Tokens of GLSL and C++ text, and the functions and structs of a GLSL text, found without a compiler. Both branches of
// an #if count. A line joined to the next by a backslash is one line, as for a compiler.
#pragma once

#include <string>
#include <vector>

namespace relief {

/// Returns whether a word of GLSL or C++ may contain the character: a letter, a digit or '_'.
bool is_word_character(char c);

/// A token: the half-open range [begin, end) of the text.
struct CodeToken {
    /// A literal is a quoted text or character. A directive is a preprocessor line with its comments.
    enum Kind { word, number, symbol, literal, comment, directive };
    Kind kind;
    size_t begin, end;
    std::string text;  ///< without the line ends that a backslash joins; a symbol is one character

    bool is_code() const { return kind != comment && kind != directive; }
};
/// Returns all tokens of a text. Between them is white space.
std::vector<CodeToken> all_tokens(const std::string& text);
/// Returns the tokens without comments and preprocessor lines.
std::vector<CodeToken> code_tokens(const std::string& text);
/// Returns the tokens of a preprocessor line, from its '#' on, without comments. Their places are in the token's text.
std::vector<CodeToken> tokens_of_directive(const CodeToken& directive);

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
