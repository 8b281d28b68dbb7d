#version 410 core
// A ball among the reliefs.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;

uniform mat4 u_clip_from_world;
uniform vec3 u_centre;

out vec3 v_position;
out vec3 v_normal;

void main() {
    v_position = a_position + u_centre;
    v_normal = a_normal;
    gl_Position = u_clip_from_world * vec4(v_position, 1.0);
}
