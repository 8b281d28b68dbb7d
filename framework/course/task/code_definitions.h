// Definitions at the top level of a GLSL or C++ text, found without a compiler: functions, types, variables, macros.
// Code in the branch of an #if that is never compiled (`#if 0`) does not count. All other branches count.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "framework/core/base/code_text.h"

namespace relief {

/// A function's name and the types of its parameters, without the parameters' names.
struct CodeSignature {
    std::string name;
    std::vector<std::string> types;  ///< as written: "const Triangle&", "float[9]"

    /// Returns "solve(const Triangle&)".
    std::string text() const;
    /// Returns whether a definition with the signature `other` can be the function that this one names. The names and
    /// the counts of parameters are equal. Types differ only if one of them may be another name of the other.
    bool fits(const CodeSignature& other) const;
};
/// Parses a text such as "crossing(float, float)".
CodeSignature parse_signature(const std::string& text);

struct CodeDefinition {
    /// A directive is a preprocessor line that defines nothing, such as an #include. Stray code has no place outside of
    /// functions: a bracket too many, and the statements after it.
    enum Kind { function, prototype, type, variable, macro, directive, other, stray };
    Kind kind = other;
    std::vector<std::string> names;  ///< names that it defines
    CodeSignature signature;         ///< of a function or prototype
    size_t begin = 0, end = 0;       ///< half-open range of the text, without comments before it
    size_t body = 0;                 ///< offset of a function's opening brace
    /// The #if lines around it, from the outermost, each with the #elif and #else lines before it.
    std::vector<std::string> conditions;
    std::vector<CodeToken> tokens;        ///< without comments and preprocessor lines
    std::set<std::string> words, called;  ///< all words in it, and those before a parenthesis

    /// Returns a text that two definitions of the same thing share.
    std::string key() const;
    bool defines(const std::string& name) const;
};

struct CodeDefinitions {
    std::vector<CodeDefinition> list;  ///< in the text's order
    /// Whether all brackets match. Otherwise a function ends where the next one begins.
    bool is_balanced = true;
};
CodeDefinitions definitions_of(const std::string& text);

/// Returns for each definition whether those for which `roots` is true use it, directly or through each other. Does not
/// go through the definitions for which `barriers` is true.
std::vector<bool> used_by(const std::vector<CodeDefinition>& list, const std::vector<bool>& roots,
                          const std::vector<bool>& barriers);

}  // namespace relief
