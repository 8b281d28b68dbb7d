#version 410 core
// A model on the screen. Its coordinates are world coordinates.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
#ifdef MAP
layout(location = 3) in vec2 a_uv;
#ifndef OBJECT_SPACE
layout(location = 2) in vec4 a_tangent;
#endif
#endif

uniform mat4 u_clip_from_world;

out vec3 v_position;
out vec3 v_normal;
#ifdef MAP
out vec2 v_uv;
#ifndef OBJECT_SPACE
out vec4 v_tangent;
out vec3 v_bitangent;
#endif
#endif

void main() {
    v_position = a_position;
    v_normal = a_normal;
#ifdef MAP
    v_uv = a_uv;
#ifndef OBJECT_SPACE
    v_tangent = a_tangent;
    v_bitangent = a_tangent.w * cross(a_normal, a_tangent.xyz);
#endif
#endif
    gl_Position = u_clip_from_world * vec4(a_position, 1.0);
}
