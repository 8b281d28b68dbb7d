#version 410 core
// Searches a relief once for each texel of a map of rays, by the shaders of labs 10, 11 and 12 or by commonly copied
// code. Red and green: uv of the hit. Blue: 1 if the search ran out of iterations.

#include "common/cell_walk.glsl"
#include "common/height_cell.glsl"
#if defined EXACT
#include "12_relief_exact/search.glsl"
#elif defined EXACT_COMMON
#include "common/exact_hit.glsl"
#elif defined STEEP
#include "common/unfinished.glsl"
#include "10_parallax_offset/task.glsl"
#elif defined MARCH
#include "11_parallax_occlusion/task.glsl"
#endif

#ifndef EXACT
uniform sampler2D s_heights;
uniform float u_highest;
#endif
#ifdef EXACT_COMMON
uniform sampler2DArray s_windows;
uniform mat4 u_window_extent;
#endif
uniform sampler2D s_rays;       // uv, and the cosine and sine of the ray's azimuth
uniform float u_sine, u_cosine; // of the angle between the ray and the normal
uniform float u_depth;          // in tiles

layout(location = 0) out vec4 o_hit;

float height_at(vec2 uv) { return textureLod(s_heights, uv, 0.0).r; }

#ifdef USUAL
// 8 to 32 layers by angle, then a linear intersection. The cosine is not clamped.
vec4 hit(vec2 uv, vec3 to_eye) {
    float layers = mix(32.0, 8.0, abs(to_eye.z)), layer = 0.0;
    vec2 stride = to_eye.xy / to_eye.z * u_depth / layers, at = uv;
    float deep = 1.0 - height_at(at);
    int i = 0;
    for (; layer < deep && i < 1000; ++i) {
        at -= stride;
        deep = 1.0 - height_at(at);
        layer += 1.0 / layers;
    }
    vec2 before = at + stride;
    float past = deep - layer, early = 1.0 - height_at(before) - layer + 1.0 / layers;
    return vec4(mix(at, before, past / (past - early)), i >= 1000 ? 1.0 : 0.0, 0.0);
}
#elif defined RELIEF_MAPPING
// 32 steps, then five bisections (Policarpo, Oliveira and Comba 2005).
vec4 hit(vec2 uv, vec3 to_eye) {
    vec2 along = -to_eye.xy / to_eye.z * u_depth;
    float size = 1.0 / 32.0, t = 0.0, best = 1.0;
    for (int i = 0; i < 31; ++i) {
        t += size;
        if (best > 0.996 && t >= 1.0 - height_at(uv + t * along)) best = t;
    }
    t = best;
    for (int i = 0; i < 5; ++i) {
        size *= 0.5;
        if (t >= 1.0 - height_at(uv + t * along)) best = t, t -= 2.0 * size;
        t += size;
    }
    return vec4(uv + best * along, 0.0, 0.0);
}
#elif defined NUDGED
// Walks from cell to cell by position: to where the ray leaves a cell, plus 1e-4 texels to reach the next cell. At
// positions of several thousand texels this offset is lost to rounding.
vec4 hit(vec2 uv, vec3 to_eye) {
    vec2 size = vec2(textureSize(s_heights, 0));
    vec2 from = uv * size - 0.5, along = -to_eye.xy / to_eye.z * u_depth * size;
    vec2 inverse = 1.0 / mix(along, vec2(1e-9), equal(along, vec2(0.0)));
    float t = 1.0 - u_highest;
    int i = 0;
    for (; i < 65000 && t < 1.0; ++i) {
        vec2 cell = floor(from + t * along + 1e-4 * sign(along)), walls = (cell + step(0.0, along) - from) * inverse;
        float end = clamp(min(walls.x, walls.y), t, 1.0);
        vec3 gap = gap_above_cell(cell_corners(s_heights, ivec2(mod(cell, size))), vec3(from + t * along - cell, 1.0 - t),
                                  vec3(from + end * along - cell, 1.0 - end));
        if (closes(gap)) return vec4(uv + mix(t, end, first_closing(gap)) * along / size, 0.0, 0.0);
        t = end;
    }
    return vec4(uv + min(t, 1.0) * along / size, t < 1.0 ? 1.0 : 0.0, 0.0);
}
#else
vec4 hit(vec2 uv, vec3 to_eye) {
    const float flattest = 0.002;  // flatter rays are clamped to it, in all labs
    float slant = max(to_eye.z, flattest);
    vec2 along = -to_eye.xy / slant * u_depth;
    vec2 size = vec2(textureSize(s_heights, 0));
#if defined EXACT
    ReliefHit found = first_hit(ReliefRay(uv * size - 0.5, along * size, vec3(1.0, -1.0, 0.0)), true, 1.0 - u_highest,
                                1.0, 0);
    return vec4(uv + found.t * along, found.stopped ? 1.0 : 0.0, 0.0);
#elif defined EXACT_COMMON
    float t = exact_hit(s_heights, s_windows, u_window_extent, uv, along, vec2(1.0 - u_highest, 1.0));
    return vec4(uv + t * along, 0.0, 0.0);
#elif defined STEEP
    return vec4(on_ray(uv, along, steep_t(s_heights, uv, along, 32)), 0.0, 0.0);
#else
    ReliefRay ray = ReliefRay(uv, along, slant, 0.0);
    float steps = BY_TEXEL > 0 ? steps_by_texel(ray, size, float(BY_TEXEL)) : 8.0;
    Bracket b = refined(s_heights, ray, march(s_heights, ray, steps), 2, secant);
    return vec4(uv + mix(b.before, b.after, crossing(b.gap_before, b.gap_after)) * along, 0.0, 0.0);
#endif
}
#endif

void main() {
    vec4 ray = texelFetch(s_rays, ivec2(gl_FragCoord.xy), 0);
    o_hit = hit(ray.xy, vec3(ray.zw * u_sine, u_cosine));
}
