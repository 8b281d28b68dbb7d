#version 410 core
// The sea: its normal by one of several rules, the mirrored sky, and the sun's highlight by the distribution of slopes
// in a pixel.

#include "15_ocean/maps.glsl"
#include "15_ocean/sky.glsl"
#include "common/unfinished.glsl"
#include "15_ocean/task.glsl"
#include "common/heat.glsl"
#include "common/srgb.glsl"

// The rules for the normal of two maps: values of COMBINE.
#define MEAN 0
#define SLOPES 1

#if defined FAR_LEAN || defined FAR_SAMPLES
#define FROM_MOMENTS
#endif

in vec3 v_place;

uniform float u_eye_height;
uniform vec3 u_to_light;
uniform float u_shininess;
uniform float u_detail;     // tiles of the normals per tile of the heights
uniform float u_split;      // x in pixels; to its right the second rule is used
uniform vec3 u_forward;
uniform vec3 u_pixel_right;  // a pixel's width and height, one metre ahead
uniform vec3 u_pixel_up;
uniform float u_steepest;    // approximate upper bound of slopes
uniform vec3 u_wire;
uniform float u_error_scale;
uniform vec4 u_waves[48];    // k, amplitude, phase; first map 0, then map 1

layout(location = 0) out vec4 o_color;

float amplitude(int map) { return map == 0 ? u_amplitude.x : u_amplitude.y; }
float tiles(int map) { return map == 0 ? u_tiles.x : u_tiles.y; }

// ---- slopes of one map

vec2 exact_slope(vec2 place, int map) {
    vec2 uv = map_uv(place, map), sum = vec2(0.0);
    // Heights of a file have no formula; their slopes are differences in floats.
#ifdef OWN_FIRST
    if (map == 0) return textureLod(s_waves_1, uv, 0.0).xy * (amplitude(0) * tiles(0));
#endif
#ifdef OWN_SECOND
    if (map == 1) return textureLod(s_waves_2, uv, 0.0).xy * (amplitude(1) * tiles(1));
#endif
    for (int i = 0; i < 24; ++i) {
        vec4 wave = u_waves[24 * map + i];
        sum -= wave.xy * (wave.z * sin(6.28318531 * fract(dot(wave.xy, fract(uv))) + wave.w));
    }
    return sum * (6.28318531 / tile_metres * amplitude(map) * tiles(map));
}

vec2 slope_by_heights(sampler2D waves, vec2 uv, int map) {
    float texel = 1.0 / map_texels;
    vec2 rise = vec2(read_map(waves, uv + vec2(texel, 0.0)).z - read_map(waves, uv - vec2(texel, 0.0)).z,
                     read_map(waves, uv + vec2(0.0, texel)).z - read_map(waves, uv - vec2(0.0, texel)).z);
    return rise / (2.0 * texel * tile_metres) * amplitude(map) * tiles(map);
}

vec2 map_slope(sampler2D waves, sampler2D normals, vec2 place, int map) {
#ifdef NORMALS_ANALYTIC
    return exact_slope(place, map);
#else
    vec2 uv = map_uv(place, map) * u_detail;
#ifdef NORMALS_BY_HEIGHTS
    return slope_by_heights(waves, uv, map);
#else
    return slope_of(read_map(normals, uv), amplitude(map), tiles(map));
#endif
#endif
}

// ---- normals of two maps together; z points upwards in both

vec3 with_slope(vec2 slope) { return vec3(-slope, 1.0) * inversesqrt(1.0 + dot(slope, slope)); }

vec3 combined(vec2 first, vec2 second, int rule) {
    if (rule == SLOPES) return sea_normal(first, second);
    return normalize((with_slope(first) + with_slope(second)).xzy);
}

vec3 normal_at(vec2 place, int rule) {
#ifdef NORMALS_ANALYTIC
    vec2 slope = vec2(0.0);
#ifdef FIRST
    slope += exact_slope(place, 0);
#endif
#ifdef SECOND
    slope += exact_slope(place, 1);
#endif
    return normalize(cross(vec3(0.0, slope.y, 1.0), vec3(1.0, slope.x, 0.0)));
#else
    vec2 first = vec2(0.0), second = vec2(0.0);
#ifdef FIRST
    first = map_slope(s_waves_1, s_normals_1, place, 0);
#endif
#ifdef SECOND
    second = map_slope(s_waves_2, s_normals_2, place, 1);
#endif
    return combined(first, second, rule);
#endif
}

// ---- the sun's light

// Returns the slope that would mirror the sun. `seen` is false if there is none.
vec2 sun_slope(vec3 to_eye, out bool seen) {
    vec3 sum = to_eye + u_to_light;
    seen = sum.y > 1e-3 && u_to_light.y >= 0.0;
    return -sum.xz / max(sum.y, 1e-3);
}

// The distribution of slopes in a pixel.
struct Water {
    vec2 mean;
    vec3 variance;  // along x, along z, covariance
};

#ifdef FROM_MOMENTS
void add_map(inout Water water, sampler2D waves, sampler2D moments, vec2 place, int map) {
    vec2 uv = map_uv(place, map), mean = read_map(waves, uv).xy;
    water.mean += mean * (amplitude(map) * tiles(map));
    water.variance += spread(read_map(moments, uv), mean, amplitude(map), tiles(map));
}
#else
// The mean of unit normals is the shorter the more they differ. With its length l the variance is about (1 - l) / l.
void add_map(inout Water water, sampler2D normals, vec2 place, int map) {
    float l = min(1.0, length(read_map(normals, map_uv(place, map)) * 2.0 - 1.0)), scale = amplitude(map) * tiles(map);
    water.variance.xy += scale * scale * (1.0 - l) / l;
}
#endif

Water water_at(vec2 place, vec3 normal, int rule) {
    Water water = Water(vec2(0.0), vec3(0.0));
#ifdef FROM_MOMENTS
#ifdef FIRST
    add_map(water, s_waves_1, s_moments_1, place, 0);
#endif
#ifdef SECOND
    add_map(water, s_waves_2, s_moments_2, place, 1);
#endif
    if (rule != SLOPES) water.mean = -normal.xz / normal.y;
#else
    water.mean = -normal.xz / normal.y;
#ifdef FAR_TOKSVIG
#ifdef FIRST
    add_map(water, s_normals_1, place, 0);
#endif
#ifdef SECOND
    add_map(water, s_normals_2, place, 1);
#endif
#endif
#endif
    return water;
}

#ifdef FAR_SAMPLES
// Returns the mean of the light over SIDE x SIDE places of the pixel's footprint, from level 0.
float sampled_highlight(vec3 position, vec2 wanted) {
    float reach = max(0.0, length(wanted) - u_steepest);
    if (0.5 * u_shininess * reach * reach > 20.0) return 0.0;
    float depth = dot(position, u_forward), light = 0.0;
    vec3 way = position / depth;
    vec2 across = depth * (u_pixel_right.xz - way.xz * (u_pixel_right.y / way.y)) / float(SIDE);
    vec2 along = depth * (u_pixel_up.xz - way.xz * (u_pixel_up.y / way.y)) / float(SIDE);
    vec2 middle = position.xz - 0.5 * float(SIDE - 1) * (across + along);
    for (int row = 0; row < SIDE; ++row)
        for (int column = 0; column < SIDE; ++column) {
            vec2 place = middle + float(column) * across + float(row) * along, off = -wanted;
#ifdef FIRST
            off += textureLod(s_waves_1, map_uv(place, 0), 0.0).xy * (u_amplitude.x * u_tiles.x);
#endif
#ifdef SECOND
            off += textureLod(s_waves_2, map_uv(place, 1), 0.0).xy * (u_amplitude.y * u_tiles.y);
#endif
            light += exp(-0.5 * u_shininess * dot(off, off));
        }
    return light / float(SIDE * SIDE);
}
#endif

// Returns the share of the sun's light. `position` is relative to the eye.
float glitter(vec3 position, Water water) {
    bool seen;
    vec2 wanted = sun_slope(-normalize(position), seen);
    if (!seen) return 0.0;
#ifdef FAR_SAMPLES
    return sampled_highlight(position, wanted);
#else
    return highlight(wanted - water.mean, water.variance, u_shininess);
#endif
}

float exact_fresnel(float cosine) {
    float c = clamp(cosine, 0.0, 1.0), within = sqrt(1.0 - (1.0 - c * c) * 9.0 / 16.0);
    float s = (3.0 * c - 4.0 * within) / (3.0 * c + 4.0 * within);
    float p = (3.0 * within - 4.0 * c) / (3.0 * within + 4.0 * c);
    return 0.5 * (s * s + p * p);
}

float mirrored_share(float cosine) {
#ifdef EXACT_FRESNEL
    return exact_fresnel(cosine);
#else
    return fresnel(cosine);
#endif
}

vec3 lit(vec3 position, vec3 normal, Water water) {
    vec3 to_eye = -normalize(position);
    // In a pixel, waves that lean towards the eye cover more of it. So the mean visible normal leans towards the eye.
    vec3 variance = water.variance;
    vec2 way = to_eye.xz / max(length(to_eye.xz), 1e-6);
    float within = way.x * way.x * variance.x + 2.0 * way.x * way.y * variance.z + way.y * way.y * variance.y;
    float lean = within / (max(to_eye.y, 0.0) + 0.8 * sqrt(within) + 1e-4);
    vec3 visible = normalize(normal + vec3(way.x, 0.0, way.y) * lean);

    float share = mirrored_share(dot(visible, to_eye));
    vec3 mirror = sky(reflected(to_eye, visible), u_to_light);
#ifdef BLUE_MATERIAL
    // A surface of blue paint: it scatters light in all directions, which water does not.
    vec3 body = vec3(0.03, 0.16, 0.45) * (0.5 * sky(vec3(0.0, 1.0, 0.0), u_to_light) +
                                          vec3(1.9, 1.5, 1.1) * max(dot(visible, u_to_light), 0.0));
#else
    // Light from within the water: more of it comes through the crests of waves in front of the sun.
    float day = 0.2 + 0.8 * clamp(u_to_light.y * 2.0, 0.0, 1.0);
    float crest = clamp(0.35 + 0.9 * v_place.z, 0.0, 1.5);
    float through = pow(max(dot(-to_eye, u_to_light), 0.0), 4.0) * crest;
    vec3 body = day * (vec3(0.004, 0.022, 0.038) + vec3(0.004, 0.030, 0.032) * crest) +
                 through * vec3(0.012, 0.050, 0.040);
#endif
    vec3 light = mix(body, mirror, share);
    vec3 halfway = normalize(to_eye + u_to_light + vec3(0.0, 1e-5, 0.0));
    float sun = glitter(position, water) * u_shininess / 512.0 * mirrored_share(dot(halfway, to_eye));
    light += vec3(26.0, 13.0, 4.4) * (sun * 0.25 / max(abs(to_eye.y), 0.07));
    // Mist, where the sea meets the sky.
    float away = length(position);
    vec3 level_ = normalize(vec3(position.x, 0.01 * away, position.z));
    return mix(light, sky(level_, u_to_light), 0.75 * (1.0 - exp(-away / 9000.0)));
}

void main() {
    vec3 position = vec3(v_place.x, v_place.z - u_eye_height, v_place.y);
    int rule = COMBINE;
#ifdef WIPE
    if (gl_FragCoord.x >= u_split) rule = SLOPES;
#endif
#if defined WIRE
    o_color = vec4(u_wire, 1.0);
#elif defined PROBE_sigma
    o_color = probed(vec4(water_at(v_place.xy, vec3(0.0, 1.0, 0.0), SLOPES).variance, 0.0));
#elif defined PROBE_height
    float height = v_place.z;
#ifdef FLAT
    height = 0.0;
#ifdef FIRST
    height += u_amplitude.x * read_map(s_waves_1, map_uv(v_place.xy, 0)).z;
#endif
#ifdef SECOND
    height += u_amplitude.y * read_map(s_waves_2, map_uv(v_place.xy, 1)).z;
#endif
#endif
    o_color = probed(vec4(height, 0.0, 0.0, 0.0));
#elif defined PROBE_slope && !(defined FIRST && defined SECOND)
#ifdef FIRST
    o_color = probed(vec4(map_slope(s_waves_1, s_normals_1, v_place.xy, 0), 0.0, 0.0));
#else
    o_color = probed(vec4(map_slope(s_waves_2, s_normals_2, v_place.xy, 1), 0.0, 0.0));
#endif
#elif defined PROBE_glitter && COMBINE == SLOPES && defined FROM_MOMENTS
    o_color = probed(vec4(glitter(position, water_at(v_place.xy, vec3(0.0, 1.0, 0.0), SLOPES)), 0.0, 0.0, 0.0));
#else
    vec3 normal = normal_at(v_place.xy, rule), to_eye = -normalize(position);
#if defined PROBE_normal
    o_color = probed(vec4(normal, 0.0));
#elif defined PROBE_slope
    o_color = probed(vec4(-normal.xz / normal.y, 0.0, 0.0));
#elif defined PROBE_glitter
    o_color = probed(vec4(glitter(position, water_at(v_place.xy, normal, rule)), 0.0, 0.0, 0.0));
#elif defined PROBE_reflection
    o_color = probed(vec4(reflected(to_eye, normal), 0.0));
#elif defined PROBE_fresnel
    o_color = probed(vec4(mirrored_share(dot(normal, to_eye)), 0.0, 0.0, 0.0));
#elif defined ERROR || defined MEASURE
    vec2 slope = vec2(0.0);
#ifdef FIRST
    slope += exact_slope(v_place.xy, 0);
#endif
#ifdef SECOND
    slope += exact_slope(v_place.xy, 1);
#endif
    vec3 exact = normalize(cross(vec3(0.0, slope.y, 1.0), vec3(1.0, slope.x, 0.0)));
    float degrees_ = degrees(atan(length(cross(exact, normal)), dot(exact, normal)));
#ifdef MEASURE
    o_color = measured(vec4(degrees_, 0.0, 0.0, 0.0));
#else
    o_color = finished(vec4(heat(degrees_ / u_error_scale), 1.0), gl_FragCoord.xy);
#endif
#else
    vec3 light = lit(position, normal, water_at(v_place.xy, normal, rule));
    o_color = finished(vec4(srgb_from_linear(exposed(light)), 1.0), gl_FragCoord.xy);
#endif
#endif
}
