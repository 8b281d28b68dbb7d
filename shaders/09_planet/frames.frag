#version 410 core
// A line of a frame in its colour.

#include "09_planet/depth.glsl"

flat in vec3 v_color;

layout(location = 0) out vec4 o_color;

void main() {
    write_depth();
    o_color = vec4(v_color, 1.0);
}
