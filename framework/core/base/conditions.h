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

/// Macros by name, with the tokens of their #define lines. A macro without tokens may be defined or not.
using Macros = std::map<std::string, std::vector<CodeToken>>;
/// Applies a #define or an #undef line. Other lines have no effect.
void define(Macros& macros, const std::vector<CodeToken>& tokens);

/// Returns the half-open ranges of a text that its #if lines leave out for certain, in order. `macros` are those
/// defined before the text. A branch stays if its condition has a macro of GLSL or of an extension, a name without a
/// definition, or an operator that Expression in conditions.cpp does not read. Returns nothing if an #if has no #endif,
/// or an #endif, #else or #elif no #if.
std::optional<std::vector<std::pair<size_t, size_t>>> left_out(const std::vector<Directive>& lines, Macros macros);

}  // namespace relief
