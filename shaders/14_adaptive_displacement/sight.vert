#version 410 core
// The eye and a rectangle in its field of view, as eight lines.

uniform mat4 u_clip_from_world;
uniform vec3 u_places[5];  // the eye, then around the rectangle

void main() {
    int line = gl_VertexID / 2, end = gl_VertexID % 2;
    int place = line < 4 ? end * (1 + line) : 1 + (line + end) % 4;
    gl_Position = u_clip_from_world * vec4(u_places[place], 1.0);
}
