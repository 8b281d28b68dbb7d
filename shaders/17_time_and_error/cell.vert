#version 410 core
// Passes on the corners of the cells that are displaced.

layout(location = 0) in vec2 a_place;  // metres

out vec2 v_corner;

void main() { v_corner = a_place; }
