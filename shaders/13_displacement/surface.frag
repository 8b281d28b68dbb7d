#version 410 core
// A displaced surface, lit with normals from one of four sources.

#include "common/unfinished.glsl"
#include "13_displacement/task.glsl"
#include "common/light.glsl"
#include "common/patch.glsl"
#include "common/srgb.glsl"

// The order of `normals` in lab.cpp.
#define BASE 0
#define MAP 1
#define HEIGHTS 2
#define SURFACE 3

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;
in vec3 v_base;
in vec3 v_direction;
in vec3 v_place;
in float v_mip;
in float v_unfinished;

uniform vec3 u_eye;
uniform float u_scale;
uniform vec2 u_normal_strength;
uniform vec3 u_to_light;
uniform vec3 u_wire;
uniform sampler2D s_heights;
uniform sampler2D s_albedo;
uniform sampler2D s_normals;

#ifdef SHADOW
uniform mat4 u_map_from_model;  // place in the shadow map, and depth
uniform sampler2DShadow s_shadow;
#endif

layout(location = 0) out vec4 o_color;

vec3 surface_normal() {
#if NORMALS == BASE
    return normalize(v_normal);
#elif NORMALS == MAP
    vec3 normal = normalize(v_normal), bitangent = v_tangent.w * normalize(cross(normal, v_tangent.xyz));
    vec3 stored = texture(s_normals, v_uv).xyz * 2.0 - 1.0;
    return normalize(mat3(v_tangent.w * cross(bitangent, normal), bitangent, normal) *
                     vec3(stored.xy * u_normal_strength, max(stored.z, 0.01)));
#else
    float level = max(textureQueryLod(s_heights, v_uv).y, 0.0);
    vec2 slope = height_slope(s_heights, v_uv, level, vec2(textureSize(s_heights, 0)));
    // Over a triangle base and direction are linear functions of the uv, also in perspective.
    vec2 uv_x = dFdx(v_uv), uv_y = dFdy(v_uv);
    mat2x3 base = by_uv(dFdx(v_base), dFdy(v_base), uv_x, uv_y), turn = mat2x3(0.0);
#if NORMALS == SURFACE
    turn = by_uv(dFdx(v_direction), dFdy(v_direction), uv_x, uv_y);
    turn = mat2x3(turn_of_unit(v_direction, turn[0]), turn_of_unit(v_direction, turn[1]));
#endif
    return displaced_normal(base[0], base[1], normalize(v_direction), turn[0], turn[1], read_height(s_heights, v_uv, level),
                            slope, u_scale);
#endif
}

// Returns the share of the light that no other part of the surface hides.
float lit_share() {
#ifdef SHADOW
    return texture(s_shadow, (u_map_from_model * vec4(v_position, 1.0)).xyz);
#else
    return 1.0;
#endif
}

void main() {
    vec3 normal = surface_normal(), to_eye = normalize(u_eye - v_position);
    is_unfinished = is_unfinished || v_unfinished > 0.0;
#if defined PROBE_depth
    o_color = probed(vec4(distance(u_eye, v_position), 0.0, 0.0, 0.0));
#elif defined PROBE_normal
    o_color = probed(vec4(normal, 0.0));
#elif defined PROBE_place
    o_color = probed(vec4(v_place, 0.0));
#elif defined PROBE_mip
    o_color = probed(vec4(v_mip, 0.0, 0.0, 0.0));
#elif defined PROBE_slope
    float level = max(textureQueryLod(s_heights, v_uv).y, 0.0);
    o_color = probed(vec4(height_slope(s_heights, v_uv, level, vec2(textureSize(s_heights, 0))), 0.0, 0.0));
#elif defined PROBE_winding
    o_color = probed(vec4(gl_FrontFacing ? 1.0 : -1.0, 0.0, 0.0, 0.0));
#elif defined PROBE_shadow
    o_color = probed(vec4(lit_share(), 0.0, 0.0, 0.0));
#elif defined DEPTH
    o_color = vec4(0.0);  // there is no colour in a shadow map
#elif defined WIRE
    o_color = finished(vec4(u_wire, 1.0), gl_FragCoord.xy);
#else
    if (!gl_FrontFacing) normal = -normal;
#ifdef PACKED
    vec3 maps = texture(s_heights, v_uv).rgb;  // height, gloss, occlusion
    float open = maps.b, specular = 0.3 * maps.g, shininess = mix(4.0, 80.0, maps.g);
#else
    float open = mix(0.45, 1.0, textureLod(s_heights, v_uv, 0.0).r);  // the depths see less of the sky
    float specular = 0.03, shininess = 24.0;
#endif
    vec3 albedo = texture(s_albedo, v_uv).rgb;
    vec3 light = open * albedo * mix(vec3(0.10, 0.09, 0.08), vec3(0.26, 0.30, 0.37), 0.5 + 0.5 * normal.y);
    light += lit_share() * vec3(1.7, 1.56, 1.36) *
             blinn_phong(albedo, specular, shininess, normal, u_to_light, to_eye);
    o_color = finished(vec4(srgb_from_linear(light), 1.0), gl_FragCoord.xy);
#endif
}
