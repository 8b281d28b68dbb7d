#version 410 core
// Passes on the corners of patches unchanged.

#include "common/patch_corner.glsl"

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;
layout(location = 4) in vec3 a_direction;
layout(location = 5) in vec2 a_height_uv;
layout(location = 6) in vec4 a_edge_uv;
layout(location = 7) in vec2 a_spacing;

out PatchCorner v_corner;
out int v_vertex;

void main() {
    v_corner = PatchCorner(a_position, a_normal, a_tangent, a_uv, a_direction, a_height_uv, a_edge_uv, a_spacing);
    v_vertex = gl_VertexID;
}
