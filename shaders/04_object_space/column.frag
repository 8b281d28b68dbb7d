#version 410 core
// Lit by one of three maps: WORLD_MAP, OBJECT_MAP or TANGENT_MAP.

#include "common/unfinished.glsl"
#include "04_object_space/task.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

in vec3 v_world;
in vec3 v_rest;
in vec2 v_uv;
#if defined TANGENT_MAP || defined PROBE_moved
in vec3 v_tangent;
in vec3 v_bitangent;
#endif

uniform mat4 u_world_from_model;
uniform float u_rate;
uniform vec3 u_eye;
uniform vec3 u_light;
uniform sampler2D s_normals;

layout(location = 0) out vec4 o_color;

//(three-maps
vec3 surface_normal() {
    vec3 stored = texture(s_normals, v_uv).xyz * 2.0 - 1.0;
#if defined WORLD_MAP
    return normalize(stored);
#elif defined OBJECT_MAP
    return world_from_object(stored, u_world_from_model);
#else
    mat3 twist = twist_jacobian(v_rest, u_rate);
    return world_from_object(object_from_tangent(stored, twist * v_tangent, twist * v_bitangent), u_world_from_model);
#endif
}
//)

void main() {
#ifdef PROBE_moved
    o_color = probed(vec4(twist_jacobian(v_rest, u_rate) * (v_tangent + v_bitangent), 0.0));
#else
    vec3 normal = surface_normal();
#ifdef PROBE_normal
    o_color = probed(vec4(normal, 0.0));
#else
    vec3 albedo = vec3(0.16, 0.32, 0.30), to_eye = normalize(u_eye - v_world), to_light = normalize(u_light - v_world);
    vec3 light = albedo * mix(vec3(0.10, 0.09, 0.08), vec3(0.22, 0.25, 0.30), 0.5 + 0.5 * normal.y);
    light += vec3(1.15, 1.05, 0.92) * blinn_phong(albedo, 0.09, 50.0, normal, to_light, to_eye);
    o_color = finished(vec4(srgb_from_linear(light), 1.0), gl_FragCoord.xy);
#endif
#endif
}
