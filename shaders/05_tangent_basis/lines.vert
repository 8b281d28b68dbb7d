#version 410 core
// Passes a vertex and its frame to the geometry stage.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;

out Frame {
    vec3 normal;
    vec4 tangent;
} v_frame;

void main() {
    v_frame.normal = a_normal;
    v_frame.tangent = a_tangent;
    gl_Position = vec4(a_position, 1.0);
}
