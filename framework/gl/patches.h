// Patches, drawn as GL says they are drawn.
#pragma once

#include "framework/gl/gl.h"

namespace relief {

/// glDrawElements of GL_PATCHES: `patches` of `control_points` each, with the GL_UNSIGNED_INT indices of the vertex array
/// that is bound, from `first_index` on. Program and state are the caller's.
///
/// Mesa's software renderer numbers the vertices that an evaluation shader makes in one draw with 16 bits: above 65,535 it
/// draws others than asked for, without an error, in quadratic time. There 8 patches are a draw, which is 33,800 vertices
/// at level 64; elsewhere all are. So gl_PrimitiveID means nothing to a shader: give what it would say to the vertices.
void draw_patches(int patches, int control_points, int first_index = 0);

}  // namespace relief
