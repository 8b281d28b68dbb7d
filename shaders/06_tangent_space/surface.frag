#version 410 core
// One light, in world space or in tangent space, by the vertex normal or by the normal map.

#include "common/unfinished.glsl"
#include "06_tangent_space/task.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

in vec3 v_position;
in vec3 v_normal;
#ifdef NORMAL_MAP
in vec4 v_tangent;
in vec2 v_uv;
uniform sampler2D s_normals;
uniform float u_strength;
uniform float u_turn;  // of the texture, radians
#endif

uniform mat4 u_world_from_model;
uniform vec3 u_scaling;  // the factors of u_world_from_model; the scaling is applied first
uniform mat3 u_rotation;
uniform vec3 u_eye;
uniform vec3 u_light;

layout(location = 0) out vec4 o_color;

vec3 unit_or(vec3 v, vec3 otherwise) {
    float squared = dot(v, v);
    return squared > 0.0 ? v * inversesqrt(squared) : otherwise;
}

vec3 surface_normal() {
    vec3 normal = normalize(v_normal);
#ifdef MODEL_SPACE
    vec3 world = normal;
#elif defined MODEL_MATRIX
    vec3 world = mat3(u_world_from_model) * normal;
#elif defined ONE_BY_ONE
    mat3 scaling = mat3(u_scaling.x, 0.0, 0.0, 0.0, u_scaling.y, 0.0, 0.0, 0.0, u_scaling.z);
    vec3 world = world_normal(world_normal(normal, scaling), u_rotation);
#else
    vec3 world = world_normal(normal, mat3(u_world_from_model));
#endif
    return unit_or(world, vec3(0.0, 0.0, 1.0));
}

#ifdef NORMAL_MAP
vec2 map_uv() {
#ifdef TURNED
    return turned_uv(v_uv, u_turn);
#else
    return v_uv;
#endif
}

mat3 world_from_surface() {
#ifdef MODEL_SPACE
    return mat3(1.0);  // the fault that view = turned shows
#else
    return mat3(u_world_from_model);
#endif
}

vec3 tangent_in_world(vec3 tangent, mat3 m) {
#ifdef TANGENT_AS_NORMAL
    return world_normal(tangent, m);  // the fault that tangent_by shows
#else
    return world_tangent(tangent, m);
#endif
}

//(frame
mat3 frame_here(vec3 normal) {
    mat3 m = world_from_surface();
    vec3 tangent = v_tangent.xyz;
#if defined TURNED && !defined TANGENT_STAYS
    tangent = turned_tangent(tangent, v_tangent.w * cross(v_normal, tangent), u_turn);
#endif
    // Where the model is mirrored, so is the frame.
    float handedness = determinant(m) < 0.0 ? -v_tangent.w : v_tangent.w;
    tangent = tangent_in_world(tangent, m);
#ifdef AS_INTERPOLATED
    return mat3(tangent, handedness * cross(normal, tangent), normal);
#else
    return tangent_frame(normal, vec4(tangent, handedness));
#endif
}
//)

vec3 normal_in_map() {
    vec3 stored = texture(s_normals, map_uv()).xyz * 2.0 - 1.0;
    return normalize(vec3(stored.xy * u_strength, stored.z));
}
#endif

void main() {
    vec3 normal = surface_normal();
    vec3 to_light = unit_or(u_light - v_position, normal), to_eye = unit_or(u_eye - v_position, normal);
#ifdef NORMAL_MAP
    mat3 frame = frame_here(normal);
    vec3 mapped = normal_in_map();
    normal = normalize(frame * mapped);
#endif
#ifdef PROBE_normal
    o_color = probed(vec4(normal, 0.0));
#else
    float up = normal.y;
#if defined NORMAL_MAP && defined IN_TANGENT_SPACE
    //(in-tangent-space
    to_light = to_tangent_space(to_light, frame);
    to_eye = to_tangent_space(to_eye, frame);
    normal = mapped;
    //)
#endif
    vec3 albedo = vec3(0.55, 0.26, 0.13);
    vec3 light = albedo * mix(vec3(0.09, 0.08, 0.08), vec3(0.22, 0.25, 0.31), 0.5 + 0.5 * up);
    light += vec3(1.2, 1.12, 1.0) * blinn_phong(albedo, 0.13, 36.0, normal, to_light, to_eye);
    o_color = finished(vec4(srgb_from_linear(light), 1.0), gl_FragCoord.xy);
#endif
}
