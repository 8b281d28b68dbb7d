#version 410 core
// The map as it is stored.

in vec2 v_uv;

uniform sampler2D s_normals;

layout(location = 0) out vec4 o_color;

void main() { o_color = vec4(texture(s_normals, v_uv).rgb, 1.0); }
