#version 410 core
// Lines of a drawing, made of triangles in clip coordinates.

layout(location = 0) in vec2 a_place;
layout(location = 1) in vec4 a_color;

out vec4 v_color;

void main() {
    v_color = a_color;
    gl_Position = vec4(a_place, 0.0, 1.0);
}
