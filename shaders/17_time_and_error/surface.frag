#version 410 core
// A wall within the budget. PLAIN, NORMAL_MAP, PARALLAX, EXACT and DISPLACEMENT compile a method in. If there are
// several, each pixel chooses the cheapest one that keeps the budget. If there is one, it is ONLY_METHOD.

#include "common/unfinished.glsl"
#include "17_time_and_error/task.glsl"
#include "common/height_cell.glsl"

// A search reads heights by these two functions only, which count the reads.
int heights_read = 0;
float read_height(sampler2D heights, vec2 place, float level) {
    ++heights_read;
    return textureLod(heights, place, level).x;
}
vec4 read_cell(sampler2D heights, ivec2 cell) {
    ++heights_read;
    return cell_corners(heights, cell);
}
#define READ_CELL read_cell
#include "common/exact_hit.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

in vec2 v_place;  // on the wall's front, or of the displaced point; metres
#ifdef DISPLACEMENT
in float v_height;
in float v_unfinished;
#else
in vec4 v_clip;
#endif

uniform vec3 u_eye;
uniform vec3 u_to_light;     // unit
uniform vec4 u_border;       // of the wall: left, lower, right, upper
uniform vec4 u_clip_along;   // a metre along the normal in clip space
uniform vec2 u_size;         // of the picture, pixels
uniform float u_budget;      // pixels
uniform float u_shares[2];   // of the budget: for thinning the relief; for the error of a method
uniform float u_scale;       // of the relief, metres
uniform vec2 u_range;        // the lowest and the highest height
uniform float u_errors[12];  // of the height map's levels
uniform int u_levels;
uniform float u_exact_taps;  // heights that a march reads in the time of an exact search
uniform vec2 u_normal_strength;
uniform float u_texels;       // of the height map, per metre
uniform float u_first_level;  // of the normal map: see first_level() in wall.h
uniform float u_flat_level;   // from this level on the normal map is nearly flat
uniform vec3 u_flat_normal;   // the mean normal of the map
uniform vec3 u_colors[5];       // of the methods

uniform sampler2D s_heights;
uniform sampler2D s_albedo;
uniform sampler2D s_normals;
uniform sampler2DArray s_windows;  // for the exact hit
uniform mat4 u_window_extent;

layout(location = 0) out vec4 o_color;

const float shininess = 48.0;

// A ray enters at `place`, at height 1 and t = 0, and reaches height 0 at place + along.
struct Ray {
    vec2 place, along;
};

// Returns the t of the hit of a march from t = between.x, where the ray may be below the surface already, to between.y,
// where it ends.
float marched(Ray ray, vec2 between, float level, float steps) {
    float stride = (between.y - between.x) / steps;
    //[solution
    float t = between.x, before = t;
    float gap = 1.0 - t - read_height(s_heights, ray.place + t * ray.along, level), gap_before = gap;
    while (gap > 0.0 && t < between.y) {
        before = t;
        gap_before = gap;
        t = min(t + stride, between.y);
        gap = 1.0 - t - read_height(s_heights, ray.place + t * ray.along, level);
    }
    return gap > 0.0 || gap_before <= 0.0 ? t : mix(before, t, gap_before / (gap_before - gap));
    //]starter
    //| // The same from the far end, and without an early exit: how to march is the subject of lab 11.
    //| float met = between.y, t = between.y, far = 1.0 - t - read_height(s_heights, ray.place + t * ray.along, level);
    //| for (int i = int(ceil(steps)) - 1; i >= 0; --i) {
    //|     float next = between.x + float(i) * stride;
    //|     float near = 1.0 - next - read_height(s_heights, ray.place + next * ray.along, level);
    //|     if (far <= 0.0) met = near > 0.0 ? mix(next, t, near / (near - far)) : next;
    //|     t = next;
    //|     far = near;
    //| }
    //| return far <= 0.0 ? t : met;
    //]
}

// The inputs of a pixel's choice of a method; members that no method needs are not computed.
struct Choice {
    float pixels;     // per metre of relief
    vec2 left;        // lowest and highest height after thinning
    float level;      // coarsest level of the height map that keeps the budget
    float taps;       // number of heights that a march would read
};

Choice look(Ray ray) {
    Choice c = Choice(0.0, vec2(0.5 * (u_range.x + u_range.y)), 0.0, 0.0);
#if defined PARALLAX || defined EXACT
    //(spend
    c.pixels = pixels_per_metre(v_clip, u_clip_along, u_size);
    float tolerance = tolerated(u_budget, c.pixels, u_scale);
    c.left = thinned(u_range.x, u_range.y, u_shares[0] * tolerance);
    //)
#ifdef PARALLAX
    float off = u_shares[1] * tolerance;
    c.level = coarsest_level(u_errors, u_levels, off);
    c.taps = max(1.0, (c.left.y - c.left.x) * length(ray.along * u_texels) * exp2(-floor(c.level)));
#ifndef ONLY_METHOD
    if (off < u_errors[0]) c.taps = 1e30;  // even level 0 is off by more
#else
    // Without another method the march has to keep the budget by shorter steps. Half the step halves the error.
    if (off > 0.0) c.taps = min(c.taps * max(1.0, u_errors[0] / off), float(max_iterations));
#endif
#endif
#endif
    return c;
}

//(chosen
int chosen(Choice c, float bumps) {
#ifdef ONLY_METHOD
    return ONLY_METHOD;
#elif defined PARALLAX
    return cheapest(c.left, bumps, c.taps, u_exact_taps);
#else
    return cheapest(c.left, bumps, 1e30, u_exact_taps);
#endif
}
//)

float seen(Ray ray, Choice c, int method) {
    vec2 between = 1.0 - c.left.yx;
#ifdef PARALLAX
    if (method == parallax) return marched(ray, between, c.level, c.taps);
#endif
#ifdef EXACT
    if (method == exact) return exact_hit(s_heights, s_windows, u_window_extent, ray.place, ray.along, between);
#endif
    return between.y;
}

vec3 lit(vec2 place, float height, float level, float bumps, vec3 to_eye) {
    vec3 albedo = textureLod(s_albedo, place, level).rgb;
    vec3 mean = u_flat_normal, normal = vec3(0.0, 0.0, 1.0);
    if (bumps > 0.0) {
        mean = textureLod(s_normals, place, level).xyz * 2.0 - 1.0;
        normal = normalize(vec3(mean.xy * u_normal_strength * bumps, max(mean.z, 0.01)));
    }
    float open = mix(0.45, 1.0, height);  // the depths see less of the sky
    vec3 light = open * albedo * mix(vec3(0.10, 0.09, 0.08), vec3(0.26, 0.30, 0.37), 0.5 + 0.5 * normal.y);
    float gloss = spread_shininess(mean, shininess);
    return light + vec3(1.7, 1.56, 1.36) * blinn_phong(albedo, 0.03, gloss, normal, u_to_light, to_eye);
}

void main() {
    // The level whose texels have the area of a pixel: see first_level() in wall.h.
    float level = max(u_first_level - 1.5 * log2(gl_FragCoord.w), 0.0), bumps = 0.0;
#if defined NORMAL_MAP || defined PARALLAX || defined EXACT || defined DISPLACEMENT
    bumps = bumps_left(level, u_flat_level, u_budget);
#endif
#ifdef DISPLACEMENT
    is_unfinished = is_unfinished || v_unfinished > 0.0;
    vec2 place = v_place;
    float height = v_height;
    int method = ONLY_METHOD;
#else
    vec3 into = vec3(v_place, 0.0) - u_eye;
    Ray ray = Ray(v_place, into.xy * (u_scale / -into.z));
    Choice c = look(ray);
    int method = chosen(c, bumps);
    float t = seen(ray, c, method), height = 1.0 - t;
    vec2 place = v_place + t * ray.along;
#ifdef MAY_LEAVE
    if (any(lessThan(place, u_border.xy)) || any(greaterThan(place, u_border.zw))) discard;
#endif
#endif
    vec3 to_eye = normalize(u_eye - vec3(place, u_scale * (height - 1.0)));

#if defined PROBE_uv
    o_color = probed(vec4(place * u_texels, 0.0, 0.0));
#elif defined PROBE_method
    o_color = probed(vec4(float(method), 0.0, 0.0, 0.0));
#elif defined PROBE_work
    o_color = probed(vec4(float(heights_read), 0.0, 0.0, 0.0));
#elif defined PROBE_pixels
    o_color = probed(vec4(c.pixels * u_scale, 0.0, 0.0, 0.0));
#elif defined PROBE_left
    o_color = probed(vec4(c.left, 0.0, 0.0));
#elif defined PROBE_level
    o_color = probed(vec4(c.level, 0.0, 0.0, 0.0));
#elif defined PROBE_shininess
    vec3 mean = textureLod(s_normals, place, level).xyz * 2.0 - 1.0;
    o_color = probed(vec4(spread_shininess(mean, shininess), 0.0, 0.0, 0.0));
#elif defined PROBE_bumps
    o_color = probed(vec4(bumps, 0.0, 0.0, 0.0));
#else
    vec3 light = lit(place, height, level, bumps, to_eye);
#ifdef METHOD_COLORS
    light = u_colors[method] * (0.22 + 1.7 * dot(light, vec3(0.3, 0.5, 0.2)));
#endif
    o_color = finished(vec4(srgb_from_linear(light), 1.0), gl_FragCoord.xy);
#endif
}
