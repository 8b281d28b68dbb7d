#version 410 core
// Counts the triangles that cover a texel, by additive blending.

uniform float u_value;

layout(location = 0) out vec4 o_count;

void main() { o_count = vec4(u_value, 0.0, 0.0, 0.0); }
