#version 410 core
// Transforms to the world, with the tangent if a normal map needs it.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;

uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_model;  // rotation, translation and uniform scale, so it transforms normals, too

out vec3 v_position;
out vec3 v_normal;
out vec2 v_uv;
#ifdef NORMAL_MAP
out vec4 v_tangent;
#endif

void main() {
    vec4 world = u_world_from_model * vec4(a_position, 1.0);
    v_position = world.xyz;
    v_normal = mat3(u_world_from_model) * a_normal;
#ifdef NORMAL_MAP
    v_tangent = vec4(mat3(u_world_from_model) * a_tangent.xyz, a_tangent.w);
#endif
    v_uv = a_uv;
    gl_Position = u_clip_from_world * world;
}
