#version 410 core
// The column, twisted about its axis and then placed in the world.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;

#ifndef BAKE
uniform mat4 u_clip_from_world;
#endif
uniform mat4 u_world_from_model;
uniform float u_rate;  // of the twist, radians per metre

out vec3 v_world;
out vec3 v_rest;  // position before the twist
out vec2 v_uv;
#if defined TANGENT_MAP || defined PROBE_moved
out vec3 v_tangent;
out vec3 v_bitangent;
#endif

void main() {
    float turn = u_rate * a_position.y, c = cos(turn), s = sin(turn);
    vec3 twisted = vec3(a_position.x * c + a_position.z * s, a_position.y, a_position.z * c - a_position.x * s);
    vec4 world = u_world_from_model * vec4(twisted, 1.0);
    v_world = world.xyz;
    v_rest = a_position;
    v_uv = a_uv;
#if defined TANGENT_MAP || defined PROBE_moved
    v_tangent = a_tangent.xyz;
    v_bitangent = a_tangent.w * cross(a_normal, a_tangent.xyz);
#endif
#ifdef BAKE
    gl_Position = vec4(2.0 * a_uv - 1.0, 0.0, 1.0);  // each texel of the baked light has one place on the column
#else
    gl_Position = u_clip_from_world * world;
#endif
}
