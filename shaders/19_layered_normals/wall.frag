#version 410 core
// A pixel of the wall z = 0: two layers of normals, their blend and its error, or the highlight of a far wall. The pixel's ray
// is met with the plane here, so that footprints are exact.

#include "common/unfinished.glsl"
#include "19_layered_normals/task.glsl"
#include "19_layered_normals/blends.glsl"
#include "19_layered_normals/stone.glsl"
#include "common/heat.glsl"
#include "common/slope_moments.glsl"
#include "common/srgb.glsl"

in vec2 v_clip;

uniform vec3 u_eye;
uniform vec3 u_forward;
uniform vec3 u_right;  // half of the picture's width, one metre ahead
uniform vec3 u_up;
uniform vec2 u_pixel;  // a pixel's width and height, in halves of the picture
uniform vec3 u_to_light;
uniform vec2 u_tile;      // side of a tile of the base and of the detail, metres
uniform vec2 u_strength;  // factors on the heights of both
uniform float u_fade;     // distance where the detail is gone, metres
uniform float u_shininess;
uniform float u_error_scale;
uniform float u_split;  // x in pixels; to its right are errors

uniform sampler2D s_base_normals;  // mean normal, height
uniform sampler2D s_base_slopes;   // mean slopes, mean squares
uniform sampler2D s_base_bends;    // mean product of the slopes, second derivatives uu, uv, vv
uniform sampler2D s_detail_normals;
uniform sampler2D s_detail_slopes;
uniform sampler2D s_detail_bends;

layout(location = 0) out vec4 o_color;

const float texels = 512.0;

struct Place {
    vec2 position;
    vec2 across, up;  // to the next pixel, and to the one above
    float distance;
    vec3 to_eye;
};

// Returns where a ray meets the wall. Precondition: it does.
Place place_at(vec3 ray) {
    float away = -u_eye.z / ray.z;
    Place place;
    place.position = u_eye.xy + away * ray.xy;
    vec3 across = u_pixel.x * u_right, up = u_pixel.y * u_up;
    place.across = away * (across.xy - ray.xy * (across.z / ray.z));
    place.up = away * (up.xy - ray.xy * (up.z / ray.z));
    place.distance = away * length(ray);
    place.to_eye = -normalize(ray);
    return place;
}

float level_of(Place place, float tile) {
    float widest = max(dot(place.across, place.across), dot(place.up, place.up));
    return max(0.5 * log2(widest) + log2(texels / tile), 0.0);
}

float strength_at(float distance) {
#ifdef NO_DETAIL
    return 0.0;
#else
    return u_strength.y * (1.0 - smoothstep(0.5 * u_fade, u_fade, distance));
#endif
}

// What a pixel reads of both layers.
struct Layers {
    vec3 base, detail;  // unit normals
    vec4 base_texel, detail_texel;
    float strength;     // of the detail
};

Layers layers_at(vec2 position, Place place) {
    Layers layers;
    layers.base_texel = textureLod(s_base_normals, position / u_tile.x, level_of(place, u_tile.x));
    layers.base = normalize(vec3(u_strength.x * layers.base_texel.xy, layers.base_texel.z));
    layers.strength = strength_at(place.distance);
    layers.detail_texel = vec4(0.0, 0.0, 1.0, 0.0);
    layers.detail = vec3(0.0, 0.0, 1.0);
    if (layers.strength > 0.0) {
        layers.detail_texel = textureLod(s_detail_normals, position / u_tile.y, level_of(place, u_tile.y));
        layers.detail = normalize(layers.detail_texel.xyz);
        if (layers.strength != 1.0) layers.detail = scaled(layers.detail, layers.strength);
    }
    return layers;
}

vec3 normal_of(Layers layers) {
    return layers.strength > 0.0 ? blended(layers.base, layers.detail) : layers.base;
}

vec3 exact_normal(Layers layers, Place place) {
    if (layers.strength == 0.0) return layers.base;
    vec3 bend = vec3(0.0);
#ifdef ALONG_NORMAL
    bend = textureLod(s_base_bends, place.position / u_tile.x, level_of(place, u_tile.x)).yzw;
#endif
    return exact_blend(layers.base, layers.detail, layers.detail_texel.w * layers.strength * u_tile.y,
                       bend * (u_strength.x / u_tile.x));
}

// ---- the highlight of a far wall

// Returns the slope of the wall that mirrors the light.
vec2 wanted_slope(vec3 to_eye) {
    vec3 halfway = to_eye + u_to_light;
    return -halfway.xy / max(halfway.z, 1e-4);
}

// Adds means (xy) and central moments (xx, yy, xy) of a layer's slopes.
void add_moments(inout vec2 mean, inout vec3 variance, sampler2D slopes, sampler2D bends, vec2 uv, float level,
                 float strength) {
    vec4 texel = textureLod(slopes, uv, level);
    mean += strength * texel.xy;
    float product = textureLod(bends, uv, level).x;
    variance += strength * strength * variance_of_slopes(texel.xy, vec3(texel.zw, product));
}

// Returns one over the variance of the slopes of a texel. A Blinn-Phong lobe is nearly a Gaussian of slopes. GGX has
// alpha^2 = 2 / (shininess + 2), which counts as twice a variance.
//(ggx
float texel_precision() {
#ifdef GGX
    return u_shininess + 2.0;
#else
    return u_shininess;
#endif
}

// Returns a lobe, 1 in its middle. `spread` is the square of the distance from there, in variances.
float falls(float spread) {
#ifdef GGX
    float tail = 1.0 + 0.5 * spread;  // alpha^2 is twice the variance
    return 1.0 / (tail * tail);
#else
    return exp(-0.5 * spread);
#endif
}
//)

// Returns the variance of the slopes that the highlight of a pixel counts on, by the knob `filter`.
float variance_of(Layers layers, Place place) {
    float variance = 1.0 / texel_precision();
#if defined FILTER_TOKSVIG
    variance += u_strength.x * u_strength.x * lost_variance(layers.base_texel.xyz);
    if (layers.strength > 0.0) variance += layers.strength * layers.strength * lost_variance(layers.detail_texel.xyz);
#elif defined FILTER_DERIVATIVES
    vec3 normal = normal_of(layers);
    variance += turning_variance(normal_of(layers_at(place.position + place.across, place)) - normal,
                                 normal_of(layers_at(place.position + place.up, place)) - normal);
#endif
    return variance;
}

// Returns the share of the light that the slopes of a pixel mirror.
float highlight(Layers layers, Place place) {
#if defined FILTER_SAMPLES
    float sum = 0.0;
    for (int row = 0; row < SIDE; ++row)
        for (int column = 0; column < SIDE; ++column) {
            vec2 off = (vec2(column, row) + 0.5) / float(SIDE) - 0.5, position = place.position + off.x * place.across + off.y * place.up;
            vec2 slope = u_strength.x * textureLod(s_base_slopes, position / u_tile.x, 0.0).xy;
            if (layers.strength > 0.0) slope += layers.strength * textureLod(s_detail_slopes, position / u_tile.y, 0.0).xy;
            slope -= wanted_slope(place.to_eye);
            sum += falls(texel_precision() * dot(slope, slope));
        }
    return sum / float(SIDE * SIDE);
#elif defined FILTER_LEAN
    vec2 mean = vec2(0.0);
    vec3 variance = vec3(1.0, 1.0, 0.0) / texel_precision();
    add_moments(mean, variance, s_base_slopes, s_base_bends, place.position / u_tile.x, level_of(place, u_tile.x), u_strength.x);
    if (layers.strength > 0.0)
        add_moments(mean, variance, s_detail_slopes, s_detail_bends, place.position / u_tile.y, level_of(place, u_tile.y), layers.strength);
    mat2 sigma = covariance_matrix(variance);
    vec2 off = wanted_slope(place.to_eye) - mean;
    return falls(dot(off, inverse(sigma) * off)) / (texel_precision() * sqrt(determinant(sigma)));
#else
    vec3 normal = normal_of(layers);
    float variance = variance_of(layers, place);
    vec2 off = wanted_slope(place.to_eye) + normal.xy / normal.z;
    return falls(dot(off, off) / variance) / (texel_precision() * variance);
#endif
}

vec3 lit(Layers layers, Place place) {
    vec3 normal = normal_of(layers);
    float height = layers.base_texel.w * u_strength.x / 0.024, fine = layers.detail_texel.w * layers.strength * 30.0;
    vec3 light = stone_lit(height, fine, place.position / u_tile.x, normal, vec3(0.0, 0.0, 1.0), u_to_light);
    light += vec3(1.0, 0.86, 0.66) * (u_gloss * highlight(layers, place) * step(0.0, u_to_light.z));
    return mix(light, haze(-place.to_eye, u_to_light), 1.0 - exp(-0.006 * place.distance));
}

void main() {
    vec3 ray = u_forward + v_clip.x * u_right + v_clip.y * u_up;
    bool is_met = ray.z * u_eye.z < 0.0 && abs(ray.z) > 1e-4 * length(ray);
#if defined MEASURE || defined PROBE
    if (!is_met) discard;
#else
    if (!is_met) {
        o_color = vec4(srgb_from_linear(haze(normalize(ray), u_to_light)), 1.0);
        return;
    }
#endif
    Place place = place_at(ray);
    Layers layers = layers_at(place.position, place);
#if defined PROBE_normal
    o_color = probed(vec4(normal_of(layers), 0.0));
#elif defined PROBE_detail
    o_color = probed(vec4(layers.detail, 0.0));
#elif defined PROBE_variance
    o_color = probed(vec4(variance_of(layers, place), 0.0, 0.0, 0.0));
#elif defined PROBE_highlight
    o_color = probed(vec4(highlight(layers, place), 0.0, 0.0, 0.0));
#elif defined PROBE_reads
    o_color = probed(vec4(layers.strength > 0.0 ? 2.0 : 1.0, 0.0, 0.0, 0.0));
#elif defined PROBE
    discard;
#else
    float off = 0.0;
#if defined MEASURE || defined ERROR
    vec3 normal = normal_of(layers), exact = exact_normal(layers, place);
    off = degrees(atan(length(cross(normal, exact)), dot(normal, exact)));
#endif
#ifdef MEASURE
    o_color = measured(vec4(off, 0.0, 0.0, 0.0));
#else
    vec3 color = srgb_from_linear(lit(layers, place));
#ifdef ERROR
    if (gl_FragCoord.x >= u_split) color = heat(off / u_error_scale);
#endif
    o_color = finished(vec4(color, 1.0), gl_FragCoord.xy);
#endif
#endif
}
