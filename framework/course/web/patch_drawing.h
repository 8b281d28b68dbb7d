// Tessellation in WebGL 2, which has none: the control and the evaluation stage run as vertex stages, and the processor
// tessellates between them.
#pragma once

#include "framework/core/gl/gl.h"

namespace relief::web {

/// Returns the function that takes the place of one of OpenGL's, or `function` itself if there is none. The ones that
/// take part: shaders and programs with tessellation stages, their uniforms, glDrawArrays with GL_PATCHES, the query of
/// the triangles that it makes, and polygons drawn as lines, which only patches can be.
GLADapiproc patch_drawing(const char* name, GLADapiproc function);

}  // namespace relief::web
