// The words of GLSL, and its words for those of other languages.
#pragma once

#include <set>
#include <string>

namespace relief {

/// The built-in functions of GLSL 4.10 (chapter 8 of its specification), without those of geometry shaders and noise.
const std::set<std::string>& built_in_functions();

/// Returns whether a word is a keyword or a type of GLSL 4.10.
bool is_glsl_keyword(const std::string& word);

/// Returns what GLSL has in place of a word of HLSL, Cg, WGSL, C++, Python or an old GLSL: "mix" for `lerp`. Empty if
/// the word is none of these.
std::string glsl_for(const std::string& word);

}  // namespace relief
