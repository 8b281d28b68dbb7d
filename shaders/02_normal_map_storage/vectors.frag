#version 410 core
// A needle, dark at its foot, or an axis in its colour.

flat in vec3 v_color;
in float v_along;

layout(location = 0) out vec4 o_color;

void main() { o_color = vec4(v_color * (0.25 + 0.75 * v_along), 1.0); }
