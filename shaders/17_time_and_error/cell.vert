#version 410 core
// The corners of cells that are to be displaced, as they are.

layout(location = 0) in vec2 a_place;  // metres

out vec2 v_corner;

void main() { v_corner = a_place; }
