#version 410 core
// World space is object space here.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
#ifndef DERIVATIVES
layout(location = 2) in vec4 a_tangent;
#endif
layout(location = 3) in vec2 a_uv;
#if defined AVERAGED || defined ORTHOGONAL
layout(location = 4) in vec3 a_bitangent;
#endif

uniform mat4 u_clip_from_world;

out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;
#ifndef DERIVATIVES
out vec4 v_tangent;
#endif
#if defined AVERAGED || defined ORTHOGONAL
out vec3 v_bitangent;
#endif

void main() {
    v_position = a_position;
    v_normal = a_normal;
    v_uv = a_uv;
#ifndef DERIVATIVES
    v_tangent = a_tangent;
#endif
#if defined AVERAGED || defined ORTHOGONAL
    v_bitangent = a_bitangent;
#endif
    gl_Position = u_clip_from_world * vec4(a_position, 1.0);
}
