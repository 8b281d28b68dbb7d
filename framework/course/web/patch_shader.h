// The stages around the tessellator as vertex stages, for WebGL 2, which has only these. Needs no GL.
#pragma once

#include <string>
#include <vector>

#include "framework/course/web/tessellator.h"

namespace relief::web {

enum class PatchStage { vertex, control, evaluation };

/// A variable that one stage passes to the next.
struct PatchVariable {
    std::string type, name;
    bool of_patch;  ///< one for the whole patch, instead of one for each corner
    bool operator==(const PatchVariable&) const = default;
};

/// A stage in GLSL 4.10 as a vertex stage, for es_shader(). Every line keeps its number.
struct PatchShader {
    std::string text;
    std::vector<PatchVariable> read, written;
    size_t values = 0;  ///< of `written`: this many vec4, named value_name(), for transform feedback
    int corners = 0;    ///< of a patch; 0 for a vertex stage
    TessellationSpacing spacing = TessellationSpacing::equal;
};
std::string value_name(size_t value);

/// Texels in a row of the texture `r_passed`, which has the values of all corners of all patches, one after the other.
constexpr int patch_texels_a_row = 1024;

/// Converts a stage of a program with tessellation:
/// - A vertex stage writes its outputs into values.
/// - A control stage runs once for each corner of each patch. Each run calls main() for all corners of the patch, in
///   their order, then writes the values of its corner, those of the patch, and the levels: the outer ones in the last
///   value but one, the inner ones in the last value.
/// - An evaluation stage runs once for each point. Its attributes are the point (0) and the number of its patch (1).
/// `text` is a stage after all #include. A patch has as many vertices before the control stage as after it and as
/// corners in its domain. If a text has both domains, in branches of an #if, a line `#define CORNERS n` says which.
/// The text may not use barrier(), gl_in or gl_out. Throws Error if the number of corners is not known, or if the text
/// passes a variable of another type than numbers, vectors, and structs of these.
PatchShader patch_shader(const std::string& text, PatchStage stage);

}  // namespace relief::web
