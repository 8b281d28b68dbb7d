#version 410 core
// A solid in model space, which is the world's.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat4 u_clip_from_world;

out vec3 v_position;
out vec3 v_normal;

void main() {
    v_position = a_position;
    v_normal = a_normal;
    gl_Position = u_clip_from_world * vec4(a_position, 1.0);
}
