#version 410 core
// A surface with a relief below it. Tangent frames go to the fragment stage as interpolated.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;

uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_model;  // a rigid motion, without scale
uniform vec2 u_repeat;            // tiles per unit of uv; x is negative if the relief is mirrored
uniform vec2 u_shift;             // in tiles

out vec3 v_position;
out vec3 v_normal;
out vec4 v_tangent;
out vec2 v_uv;

void main() {
    vec4 world = u_world_from_model * vec4(a_position, 1.0);
    float side = u_repeat.x < 0.0 ? -1.0 : 1.0;
    v_position = world.xyz;
    v_normal = mat3(u_world_from_model) * a_normal;
    v_tangent = vec4(side * (mat3(u_world_from_model) * a_tangent.xyz), side * a_tangent.w);
    v_uv = a_uv * u_repeat + u_shift;
    gl_Position = u_clip_from_world * world;
}
