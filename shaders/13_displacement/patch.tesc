#version 410 core
// Passes a patch's corners through, and sets its levels: the same everywhere.

#include "common/patch_corner.glsl"

layout(vertices = CORNERS) out;

in PatchCorner v_corner[];
in int v_vertex[];

out PatchCorner c_corner[];
patch out int c_patch;

uniform float u_level;   // along the edges
uniform float u_inside;  // within

void main() {
    //(levels
    c_corner[gl_InvocationID] = v_corner[gl_InvocationID];
    if (gl_InvocationID != 0) return;
    c_patch = v_vertex[0] / CORNERS;
    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = u_level;
    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = u_inside;
    //)
}
