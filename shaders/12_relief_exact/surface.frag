#version 410 core
// A relief by the exact hit, with shadows on itself, and with exact depth and outline.

#ifdef GL_ARB_conservative_depth
#extension GL_ARB_conservative_depth : enable
#endif

#include "12_relief_exact/search.glsl"
#include "common/heat.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"
#include "common/terminator.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

uniform mat4 u_clip_from_world;
uniform vec3 u_eye;
uniform vec3 u_to_light;       // unit: the direction to a distant light
uniform vec2 u_depth;          // a height of 1, in tiles along u and v
uniform float u_depth_metres;
uniform vec2 u_normal_strength;
uniform float u_radius;        // of a cylindrical base, metres
uniform vec4 u_border;         // lowest u and v, highest u and v
uniform int u_soft_samples;
uniform float u_turns_from;    // x in pixels: to its right the picture shows the number of iterations
uniform sampler2D s_albedo;
uniform sampler2D s_normals;

// On a flat base the view ray is computed from the pixel in double precision. A wall has 10^4 to 10^7 texels, and
// interpolated uv have an error of 0.03 to 10 texels: such a ray misses the post that it should hit. On curved bases uv
// are small, and the normals are interpolated in any case.
uniform bool u_is_flat;
uniform dmat3 u_base_from_pixel;  // takes (x, y, 1) to a direction along tangent, bitangent and normal
uniform dvec3 u_eye_over_base;    // uv in tiles, and metres above the base
uniform dvec2 u_tiles_per_metre;
uniform vec2 u_repeat, u_shift;   // the base has the uv from u_shift to u_shift + u_repeat

layout(location = 0) out vec4 o_color;
#if defined WRITE_DEPTH && defined GL_ARB_conservative_depth
layout(depth_greater) out float gl_FragDepth;  // a relief is behind its base, so early depth tests stay valid
#endif

const float least_slant = 0.002;  // lower bound: floats could not follow a flatter view ray

// Returns 1 in the light and 0 in shadow, or a share for a soft shadow.
float light_at(ReliefRay ray, int iterations) {
#if defined SOFT_SHADOW
    // The relief's height above the ray, divided by its distance, estimates the covered share of a light with a size.
    const float hardness = 3.0;
    vec2 size = vec2(textureSize(s_heights, 0));
    float covered = 0.0;
    for (int i = 1; i <= u_soft_samples; ++i) {
        float t = float(i) / float(u_soft_samples);
        float above = textureLod(s_heights, (ray.start + t * ray.along + 0.5) / size, 0.0).r - height_of(ray, t);
        covered = max(covered, above / t * hardness);
    }
    return 1.0 - min(covered, 1.0);
#else
    return first_hit(ray, false, 0.0, 1.0, iterations).missed ? 1.0 : 0.0;
#endif
}

// Returns light_at() for a hit, at `uv` in tiles and at a height in [0, 1]. `to_light` is in tangent space, and
// `iterations` is the number that the pixel has used so far.
float lit_at(vec2 uv, float height, vec3 to_light, int iterations) {
#if defined HARD_SHADOW || defined SOFT_SHADOW || defined PROBE_shadow
    if (to_light.z <= 0.0) return 0.0;
    if (height >= u_highest - 1e-4) return 1.0;
    // Starts a little above the relief, so that a hit does not shade itself.
    vec2 size = vec2(textureSize(s_heights, 0));
    return light_at(shadow_ray(vec3(uv * size - 0.5, height + 1e-4), to_light, u_depth * size), iterations);
#else
    return 1.0;
#endif
}

// Returns light_at() by a guess from the normals, without a search.
float guessed(vec3 surface, vec3 mapped) {
#ifdef GUESS_CHIANG
    return chiang_shadow(surface, mapped, u_to_light);
#else
    return dot(surface, u_to_light) > 0.0 ? guessed_shadow(surface, mapped, u_to_light) : 0.0;
#endif
}

// The point at which a view ray enters the relief.
struct Entry {
    dvec2 uv;     // tiles
    bool faces;   // the ray comes from the front of the base
    float slant;  // cosine of its angle with the normal, at least least_slant
    vec2 across;  // metres along tangent and bitangent for each metre down
};

Entry entry_at(vec3 to_eye, mat3 frame) {
    if (!u_is_flat) {
        vec3 seen = to_eye * frame;
        float slant = max(seen.z, least_slant);
        return Entry(dvec2(v_uv), seen.z > 0.0, slant, -seen.xy / slant);
    }
    dvec3 way = normalize(u_base_from_pixel * dvec3(gl_FragCoord.xy, 1.0));
    // The rasteriser rounds outlines, so the ray of a pixel there may miss the base.
    double side = u_eye_over_base.z > 0.0 ? 1.0 : -1.0, falls = max(-side * way.z, 1e-9lf);
    dvec2 uv = u_eye_over_base.xy + way.xy * u_tiles_per_metre * (side * u_eye_over_base.z / falls);
    dvec2 ends = dvec2(u_shift + u_repeat);
    uv = clamp(uv, min(dvec2(u_shift), ends), max(dvec2(u_shift), ends));
    double slant = max(falls, double(least_slant));
    return Entry(uv, side > 0.0, float(slant), vec2(way.xy / slant));
}

void main() {
    vec3 normal = normalize(v_normal);
    vec3 bitangent = v_tangent.w * normalize(cross(normal, v_tangent.xyz));
    vec3 tangent = v_tangent.w * cross(bitangent, normal);
    mat3 frame = mat3(tangent, bitangent, normal);
    vec3 to_eye = normalize(u_eye - v_position);
    Entry entry = entry_at(to_eye, frame);
    bool faces = entry.faces;
    float slant = entry.slant;
    vec2 size = vec2(textureSize(s_heights, 0)), across = entry.across;
    vec2 dx = dFdx(v_uv), dy = dFdy(v_uv);  // of the base, because hits of neighbours may differ by many texels

    // Without its whole tiles, a float is precise enough for the position.
    dvec2 tile = floor(entry.uv);
    vec2 start = vec2(entry.uv - tile);
    ReliefRay view = ReliefRay(start * size - 0.5, across * u_depth * size, vec3(1.0, -1.0, 0.0));
    ReliefHit hit = ReliefHit(0.0, false, false, 0);
#ifdef CURVED
    if (!faces) discard;
    float depth = max(u_depth_metres, 1e-9);
    float gain = bend(across.x * depth, u_radius, depth);
    view.height.z = gain;
    float t_end = gain < 0.25 ? 2.0 / (1.0 + sqrt(1.0 - 4.0 * gain)) : 1.0 / gain;
    hit = first_hit(view, false, 0.0, t_end, 0);
    if (hit.missed && gain >= 0.25) discard;
#else
    if (faces) hit = first_hit(view, true, 1.0 - u_highest, 1.0, 0);
#endif
    vec2 uv = start + hit.t * across * u_depth;  // without whole tiles
    vec3 position = v_position - to_eye * (hit.t * u_depth_metres / slant);
#ifdef OUTLINE
    vec2 on_base = vec2(tile + uv);
    if (any(lessThan(on_base, u_border.xy)) || any(greaterThan(on_base, u_border.zw))) discard;
#endif
#ifdef WRITE_DEPTH
    gl_FragDepth = window_depth(position, u_clip_from_world);
#endif

    float height = height_of(view, hit.t);
#if defined PROBE_uv
    o_color = probed(vec4((tile + uv) * size, 0.0, 0.0));
#elif defined PROBE_ray
    o_color = probed(vec4(view.along, start * size));
#elif defined PROBE_depth
    o_color = probed(vec4(distance(u_eye, position), 0.0, 0.0, 0.0));
#elif defined PROBE_steps
    o_color = probed(vec4(float(hit.iterations), hit.stopped ? 1.0 : 0.0, 0.0, 0.0));
#elif defined PROBE_shadow
    o_color = probed(vec4(lit_at(uv, height, u_to_light * frame, hit.iterations), 0.0, 0.0, 0.0));
#elif defined PROBE_guess
    // Slopes from -4 to 4, by the place in a tile.
    vec3 mapped = normalize(vec3(4.0 - 8.0 * start, 1.0));
    o_color = probed(vec4(guessed_shadow(vec3(0.0, 0.0, 1.0), mapped, u_to_light * frame), 0.0, 0.0, 0.0));
#else
    if (gl_FragCoord.x > u_turns_from) {
        o_color = finished(vec4(heat(log2(float(max(hit.iterations, 1))) / 8.0), 1.0), gl_FragCoord.xy);
        return;
    }
    vec3 albedo = textureGrad(s_albedo, uv, dx, dy).rgb;
    vec3 mapped = textureGrad(s_normals, uv, dx, dy).xyz * 2.0 - 1.0;
    vec3 n = normalize(frame * vec3(mapped.xy * u_normal_strength, mapped.z));
    vec3 light = albedo * mix(vec3(0.1, 0.09, 0.08), vec3(0.25, 0.28, 0.34), 0.5 + 0.5 * n.y);
    vec3 lamp = vec3(1.35, 1.22, 1.02);
#ifdef GUESS_SCHUESSLER
    light += lamp * blinn_phong_on_facets(albedo, 0.05, 24.0, normal, n, u_to_light, to_eye);
#else
    // A place that faces away from the light is dark, without a search.
    if (dot(n, u_to_light) > 0.0) {
#if defined GUESS_ESTEVEZ || defined GUESS_CHIANG
        float lit = guessed(normal, n);
#else
        float lit = lit_at(uv, height, u_to_light * frame, hit.iterations);
#endif
        light += lit * lamp * blinn_phong(albedo, 0.05, 24.0, n, u_to_light, to_eye);
    }
#endif
    o_color = finished(vec4(srgb_from_linear(light), 1.0), gl_FragCoord.xy);
#endif
}
