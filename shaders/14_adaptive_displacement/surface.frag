#version 410 core
// A displaced surface with a normal map, or the state of its patches in colours.

#include "common/unfinished.glsl"
#include "14_adaptive_displacement/task.glsl"
#include "14_adaptive_displacement/verdict.glsl"
#include "common/heat.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"
#include "14_adaptive_displacement/leadr.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;
in vec3 v_place;
in float v_left;
flat in float v_level;
flat in int v_verdict;
in float v_unfinished;

uniform vec3 u_seen_from;  // may differ from the eye that levels and culling are for
uniform vec2 u_normal_strength;
uniform vec3 u_to_light;
uniform float u_shininess;
uniform vec3 u_wire;
uniform sampler2D s_heights;
uniform sampler2D s_albedo;
uniform sampler2D s_normals;
uniform sampler2D s_slopes;   // of the normal map
uniform sampler2D s_squares;  // of these slopes

#ifdef SHADOW
uniform mat4 u_map_from_model;  // place in the shadow map, and depth
uniform sampler2DShadow s_shadow;
#endif

layout(location = 0) out vec4 o_color;

// Returns the share of the light that no other part of the surface hides.
float lit_share() {
#ifdef SHADOW
    return texture(s_shadow, (u_map_from_model * vec4(v_position, 1.0)).xyz);
#else
    return 1.0;
#endif
}

mat3 tangent_frame() {
    vec3 normal = normalize(v_normal), bitangent = v_tangent.w * normalize(cross(normal, v_tangent.xyz));
    return mat3(v_tangent.w * cross(bitangent, normal), bitangent, normal);
}

// Returns the normal map's normal, not normalised.
vec3 stored_normal() {
    vec3 stored = texture(s_normals, v_uv).xyz * 2.0 - 1.0;
    return vec3(stored.xy * u_normal_strength, max(stored.z, 0.01));
}

Slopes slopes_of_pixel() {
#ifdef LEADR
    vec2 mean = texture(s_slopes, v_uv).xy;
    vec3 variance = variance_of_slopes(mean, texture(s_squares, v_uv).xyz);
    vec2 strength = u_normal_strength;
    return Slopes(strength * mean, vec3(strength * strength * max(variance.xy, 0.0), strength.x * strength.y * variance.z));
#else
    vec3 stored = stored_normal();
    return Slopes(-stored.xy / stored.z, vec3(0.0));
#endif
}

// Returns alpha^2 of a highlight as wide as a Blinn-Phong one.
float squared_roughness() { return 2.0 / (u_shininess + 2.0); }

vec3 lit(vec3 albedo) {
    mat3 frame = tangent_frame();
    vec3 bumped = normalize(frame * stored_normal());
    if (!gl_FrontFacing) bumped = -bumped;
    float open = mix(0.45, 1.0, textureLod(s_heights, v_uv, 0.0).r);  // the depths see less of the sky
    vec3 light = open * albedo * mix(vec3(0.10, 0.09, 0.08), vec3(0.26, 0.30, 0.37), 0.5 + 0.5 * bumped.y);
    vec3 to_eye = normalize(u_seen_from - v_position);
#ifdef LEADR
    float shine = 0.03 * (u_shininess + 8.0) / 8.0 *
                  highlight(slopes_of_pixel(), squared_roughness(), to_eye * frame, u_to_light * frame);
    vec3 mirrored = max(dot(bumped, u_to_light), 0.0) * (albedo + shine);
#else
    vec3 mirrored = blinn_phong(albedo, 0.03, u_shininess, bumped, u_to_light, to_eye);
#endif
    return light + lit_share() * vec3(1.7, 1.56, 1.36) * mirrored;
}

void main() {
    is_unfinished = is_unfinished || v_unfinished > 0.0;
#if defined PROBE_depth
    o_color = probed(vec4(distance(u_seen_from, v_position), 0.0, 0.0, 0.0));
#elif defined PROBE_place
    o_color = probed(vec4(v_place, 0.0));
#elif defined PROBE_level
    o_color = probed(vec4(v_level, 0.0, 0.0, 0.0));
#elif defined PROBE_left
    o_color = probed(vec4(v_left, 0.0, 0.0, 0.0));
#elif defined PROBE_normal
    vec2 slope = slopes_of_pixel().mean;
#ifdef LEADR
    slope = seen_slope(slopes_of_pixel(), normalize(u_seen_from - v_position) * tangent_frame());
#endif
    o_color = probed(vec4(normalize(tangent_frame() * vec3(-slope, 1.0)), 0.0));
#elif defined PROBE_highlight
    mat3 frame = tangent_frame();
    o_color = probed(vec4(highlight(slopes_of_pixel(), squared_roughness(), normalize(u_seen_from - v_position) * frame,
                                    u_to_light * frame), 0.0, 0.0, 0.0));
#elif defined PROBE_winding
    o_color = probed(vec4(gl_FrontFacing ? 1.0 : -1.0, 0.0, 0.0, 0.0));
#elif defined DEPTH
    o_color = vec4(0.0);  // there is no colour in a shadow map
#elif defined WIRE
    o_color = finished(vec4(u_wire, 1.0), gl_FragCoord.xy);
#elif defined PATCHES
    // A culled patch has the colour of its verdict, others that of their level, paler with less displacement left.
    // Flat shading shows the triangles.
    vec3 normal = normalize(cross(dFdx(v_position), dFdy(v_position)));
    float shade = 0.62 + 0.5 * max(dot(normal, u_to_light), 0.0);
    vec3 color = v_verdict == verdict_outside ? OUTSIDE_COLOR
                 : v_verdict == verdict_away  ? AWAY_COLOR
                                              : mix(FADED_COLOR, heat(0.24 + 0.73 * log2(v_level) / 6.0), v_left);
    o_color = finished(vec4(color * shade, 1.0), gl_FragCoord.xy);
#else
    o_color = finished(vec4(srgb_from_linear(lit(texture(s_albedo, v_uv).rgb)), 1.0), gl_FragCoord.xy);
#endif
}
