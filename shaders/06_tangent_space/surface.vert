#version 410 core
// Transforms positions to the world; normals and tangents stay in object space, for the fragment stage to transform.

layout(location = 0) in vec3 a_position;
layout(location = 1) in vec3 a_normal;
#ifdef NORMAL_MAP
layout(location = 2) in vec4 a_tangent;
layout(location = 3) in vec2 a_uv;
#endif

uniform mat4 u_clip_from_world;
uniform mat4 u_world_from_model;

out vec3 v_position;
out vec3 v_normal;
#ifdef NORMAL_MAP
out vec4 v_tangent;
out vec2 v_uv;
#endif

void main() {
    vec4 world = u_world_from_model * vec4(a_position, 1.0);
    v_position = world.xyz;
    v_normal = a_normal;
#ifdef NORMAL_MAP
#if defined TANGENT_LEANING
    v_tangent = vec4(a_tangent.xyz + 0.6 * a_normal, a_tangent.w);
#elif defined TANGENT_ALONG_NORMAL
    v_tangent = vec4(a_normal, a_tangent.w);
#elif defined NO_TANGENT
    v_tangent = vec4(0.0, 0.0, 0.0, 1.0);
#else
    v_tangent = a_tangent;
#endif
    v_uv = a_uv;
#endif
    gl_Position = u_clip_from_world * world;
}
