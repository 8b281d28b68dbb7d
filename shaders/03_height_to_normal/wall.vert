#version 410 core
// A wall in the plane z = 0.

layout(location = 0) in vec3 a_position;
layout(location = 3) in vec2 a_uv;

uniform mat4 u_clip_from_world;
uniform vec2 u_wall;     // half its width and height
uniform float u_repeat;  // repeats of the map along each side

out vec3 v_position;
out vec2 v_uv;

void main() {
    v_position = a_position * vec3(u_wall, 1.0);
    v_uv = a_uv * u_repeat;
    gl_Position = u_clip_from_world * vec4(v_position, 1.0);
}
