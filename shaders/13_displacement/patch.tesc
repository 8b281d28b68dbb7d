#version 410 core
// Passes on the corners of a patch, and sets its levels, which are the same for all patches.

#include "common/patch_corner.glsl"

layout(vertices = CORNERS) out;

in PatchCorner v_corner[];
in int v_vertex[];

out PatchCorner c_corner[];
patch out int c_patch;

uniform float u_level;   // along the edges
uniform float u_inside;  // of the inside

void main() {
    //(levels
    c_corner[gl_InvocationID] = v_corner[gl_InvocationID];
    if (gl_InvocationID != 0) return;
    c_patch = v_vertex[0] / CORNERS;
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = u_level;
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = u_inside;
    //)
}
