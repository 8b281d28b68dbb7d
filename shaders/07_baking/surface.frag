#version 410 core
// A model under a raking light, or as a mirror of long lamps, by the normals of its vertices or of its map.

#include "07_baking/frames.glsl"
#include "common/unfinished.glsl"
#include "07_baking/task.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

in vec3 v_position;
in vec3 v_normal;
#ifdef MAP
in vec2 v_uv;
#ifndef OBJECT_SPACE
in vec4 v_tangent;
in vec3 v_bitangent;
#endif
uniform sampler2D s_map;
uniform float u_level;
#endif

uniform vec3 u_eye;
uniform vec3 u_to_light;

layout(location = 0) out vec4 o_color;

#ifdef MAP
vec3 mapped_normal() {
#ifdef ONE_LEVEL
    vec4 texel = textureLod(s_map, v_uv, u_level);
#else
    vec4 texel = texture(s_map, v_uv);
#endif
    if (texel.a < 0.9) is_unfinished = true;
    vec3 stored = 2.0 * texel.xyz - 1.0;
#if defined OBJECT_SPACE
    return normalize(stored);
#elif defined VERTEX_BITANGENT
    return normalize(mat3(v_tangent.xyz, v_bitangent, v_normal) * stored);
#else
    return shown_normal(stored, frame_tangent(v_normal, v_tangent), frame_normal(v_normal));
#endif
}
#endif

// Returns the light of long lamps on all sides. A flat mirror shows them straight: each lies between two planes through
// the model.
vec3 strips(vec3 direction) {
    float across = abs(fract(2.8648 * atan(direction.x + 0.35 * direction.y, direction.z)) - 0.5);
    float lamp = smoothstep(0.36, 0.16, across);
    return mix(vec3(0.03, 0.04, 0.06), vec3(0.92, 0.84, 0.68), lamp) * (0.75 + 0.25 * direction.y);
}

void main() {
#ifdef MAP
    vec3 normal = mapped_normal();
#else
    vec3 normal = normalize(v_normal);
#endif
#ifdef PROBE_normal
    o_color = probed(vec4(normal, 0.0));
#else
    vec3 to_eye = normalize(u_eye - v_position);
#ifdef MIRROR
    vec3 light = strips(reflect(-to_eye, normal));
#else
    bool is_inside = !gl_FrontFacing;
    vec3 albedo = is_inside ? vec3(0.10, 0.07, 0.06) : vec3(0.50, 0.36, 0.24);
    vec3 light = albedo * mix(vec3(0.05, 0.05, 0.06), vec3(0.13, 0.16, 0.22), 0.5 + 0.5 * normal.y);
    if (!is_inside) light += vec3(1.75, 1.55, 1.25) * blinn_phong(albedo, 0.045, 30.0, normal, u_to_light, to_eye);
#endif
    o_color = finished(vec4(srgb_from_linear(light), 1.0), gl_FragCoord.xy);
#endif
}
