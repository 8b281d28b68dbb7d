#version 410 core
// A surface with the features that its material names.

#include "08_obj_materials/features.glsl"
#include "common/unfinished.glsl"
#include "08_obj_materials/task.glsl"
#include "08_obj_materials/maps.glsl"
#ifdef LAMP
#include "08_obj_materials/lamp.glsl"
#endif
#include "08_obj_materials/light.glsl"
#include "08_obj_materials/hashed.glsl"
#include "common/srgb.glsl"

in vec3 v_place;
in vec3 v_normal;
#if (FEATURES & (COLOR_MAP | HIGHLIGHT_MAP | NORMAL_MAP | HEIGHT_MAP | MASK_MAP)) != 0
in vec2 v_uv;
#else
const vec2 v_uv = vec2(0.0);
#endif
#if (FEATURES & (NORMAL_MAP | HEIGHT_MAP)) != 0
in vec4 v_tangent;
#else
const vec4 v_tangent = vec4(1.0, 0.0, 0.0, 1.0);
#endif

uniform vec3 u_eye;
uniform vec3 u_diffuse;
uniform vec4 u_shine;     // colour and exponent
uniform vec3 u_emission;
uniform float u_opacity;
uniform float u_bump;     // depth of the heights, in widths of the map
uniform float u_threshold;
uniform float u_scales[12];  // factors on the mask's alpha, by level
uniform sampler2D s_colors;
uniform sampler2D s_highlights;
uniform sampler2D s_bumps;
uniform sampler2D s_mask;
uniform vec3 u_flat;      // the program's colour
uniform float u_dim;      // below 1 if another surface is highlighted
uniform float u_number;   // for probes: the place in the order, or the number of the surface

layout(location = 0) out vec4 o_color;
#ifdef WEIGHTED
layout(location = 1) out vec4 o_passed;
#endif

/// Returns the normal in tangent space, not of unit length.
vec3 bump() {
    if (HAS(NORMAL_MAP)) return 2.0 * texture(s_bumps, v_uv).xyz - 1.0;
    vec2 texel = 1.0 / vec2(textureSize(s_bumps, 0));
    vec2 rise = vec2(texture(s_bumps, v_uv + vec2(texel.x, 0.0)).r - texture(s_bumps, v_uv - vec2(texel.x, 0.0)).r,
                     texture(s_bumps, v_uv + vec2(0.0, texel.y)).r - texture(s_bumps, v_uv - vec2(0.0, texel.y)).r);
    return vec3(-u_bump * rise / (2.0 * texel), 1.0);
}

/// Returns the unit normal on the side of the eye.
vec3 normal_here(vec3 to_eye) {
    vec3 up = normalize(v_normal), normal = up;
    if (HAS(NORMAL_MAP) || HAS(HEIGHT_MAP)) {
        vec3 tangent = normalize(v_tangent.xyz), bumped = bump();
        normal = normalize(bumped.x * tangent + bumped.y * v_tangent.w * cross(up, tangent) + bumped.z * up);
    }
    return dot(up, to_eye) < 0.0 ? -normal : normal;
}

/// Returns the share of the pixel that the mask covers. Call it before any discard: it takes derivatives.
float mask_share() {
    vec2 right = dFdx(v_uv), up = dFdy(v_uv);
    float level = min(level_of(s_mask, right, up), 11.0);
    float alpha = textureLod(s_mask, v_uv, level).r, change = fwidth(alpha);
#if defined ALPHA_TEST
    return alpha > u_threshold ? 1.0 : 0.0;
#elif defined ALPHA_HASHED
#ifdef PROBE_coverage
    return alpha;
#else
    return alpha > hashed_threshold(v_place) ? 1.0 : 0.0;
#endif
#else
    int finer = int(level);
    float scale = mix(u_scales[finer], u_scales[min(finer + 1, 11)], level - float(finer));
    float share = covered(alpha, change, scale);
#ifdef ALPHA_KEEP
    return share >= 0.5 ? 1.0 : 0.0;
#else
    return share;
#endif
#endif
}

void main() {
    vec3 to_eye = normalize(u_eye - v_place);
    float share = 1.0;
#ifdef PLAIN_MASK
    // Probes of the surface are independent of the knob `alpha`.
    if (HAS(MASK_MAP) && textureLod(s_mask, v_uv, 0.0).r <= 0.5) discard;
#else
    if (HAS(MASK_MAP)) share = mask_share();
#endif
#if defined PROBE_coverage
    o_color = probed(vec4(share, 0.0, 0.0, 0.0));
#elif defined PROBE_material || defined PROBE_order
    o_color = vec4(u_number, 0.0, 0.0, 0.0);
#elif defined PROBE_layers
    o_color = vec4(1.0, 0.0, 0.0, 0.0);
#elif defined PROBE_normal
    o_color = probed(vec4(normal_here(to_eye), 0.0));
#elif defined PROBE_lamp
#ifdef LAMP
    o_color = probed(vec4(lamp_share(v_place - u_lamp), 0.0, 0.0, 0.0));
#else
    o_color = vec4(0.0);
#endif
#elif defined MEASURE
    // The error of this filter compared with 1024 samples, as a share of white.
    vec3 exact = by_samples(s_colors, v_uv, dFdx(v_uv), dFdy(v_uv)).rgb;
    vec3 off = abs(filtered(s_colors, v_uv).rgb - exact);
    o_color = measured(vec4((off.r + off.g + off.b) / 3.0, (exact.r + exact.g + exact.b) / 3.0, 0.0, 0.0));
#else
    vec4 shine = u_shine;
    if (HAS(HIGHLIGHT_MAP)) shine = specular_of(texture(s_highlights, v_uv));
#if defined PROBE_specular
    o_color = probed(shine);
#elif defined FLAT
    float facing = abs(dot(normal_here(to_eye), normalize(vec3(0.4, 0.8, 0.6))));
    if (share < 0.5) discard;
    o_color = vec4(0.55 * u_dim * u_flat * (0.35 + 0.65 * facing), 1.0);
#else
    vec3 color = u_diffuse;
    if (HAS(COLOR_MAP)) color *= filtered(s_colors, v_uv).rgb;
    vec3 light = u_emission + shaded(v_place, normal_here(to_eye), to_eye, color, shine, HAS(GLASS));
    light *= u_dim;
#ifdef STORED
    light = srgb_from_linear(light);
#endif
#ifndef ALPHA_TO_COVERAGE
    if (share < 0.5) discard;
#endif
    o_color = HAS(GLASS) ? over(light, u_opacity) : vec4(light, share);
#ifdef WEIGHTED
    float z = length(u_eye - v_place), weight = u_opacity * clamp(0.03 / (1e-5 + pow(z / 200.0, 4.0)), 1e-2, 3e3);
    o_passed = vec4(o_color.a);
    o_color *= weight;
#endif
    // A negative light marks unfinished tasks for encode.frag.
    if (is_unfinished) o_color = vec4(vec3(-1e6), 1.0);
#endif
#endif
}
