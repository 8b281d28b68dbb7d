// The #if lines of a shader, evaluated as its preprocessor evaluates them. Needs no GL.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/base/code_text.h"

namespace relief {

/// A preprocessor line: its range in the text, and its tokens from the '#' on.
struct Directive {
    size_t begin, end;
    std::vector<CodeToken> tokens;
};

/// Macros by name, with the tokens of their #define lines. Without tokens, it is not known whether it is defined.
using Macros = std::map<std::string, std::vector<CodeToken>>;
/// Applies a #define or an #undef line. Other lines have no effect.
void define(Macros& macros, const std::vector<CodeToken>& tokens);

/// Returns the half-open ranges of a text that its #if lines leave out for certain, in order. `macros` are those
/// defined before the text. Which extensions a driver has, what a name without a definition means, and operators that
/// are rare in an #if are not known; such a branch stays. Returns nothing if the lines have no balance.
std::optional<std::vector<std::pair<size_t, size_t>>> left_out(const std::vector<Directive>& lines, Macros macros);

}  // namespace relief
