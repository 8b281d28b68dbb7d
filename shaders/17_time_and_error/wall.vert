#version 410 core
// The front of the wall, in the plane z = 0. The relief lies behind it.

layout(location = 0) in vec2 a_place;  // metres

uniform mat4 u_clip_from_world;

out vec2 v_place;
out vec4 v_clip;

void main() {
    v_place = a_place;
    v_clip = u_clip_from_world * vec4(a_place, 0.0, 1.0);
    gl_Position = v_clip;
}
