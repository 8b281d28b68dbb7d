#version 410 core
// A sphere of directions. Each is stored in FORMAT, read back, and lit or compared with the original. One pass (STORE)
// writes codes to a texture, and the next one reads them, as from a normal map. Nothing else reaches the decoder.

#include "common/unfinished.glsl"
#include "02_normal_map_storage/task.glsl"
#include "common/heat.glsl"
#include "common/srgb.glsl"

// The order of `formats` in formats.h.
#define UNORM8 0
#define TRUNCATED 1
#define SNORM8 2
#define PAIRED8 3
#define RG8 4
#define RG16 5
#define OCTAHEDRAL 6
#define HALF 7

in vec2 v_clip;

uniform vec3 u_eye;
uniform vec3 u_forward;  // to the middle of the window; `right` and `up` lead from there to its edges
uniform vec3 u_right;
uniform vec3 u_up;
uniform float u_split;  // x in clip coordinates: lit to its left, the error to its right
uniform ivec2 u_measured;
uniform sampler2D s_codes;  // the codes that STORE wrote

layout(location = 0) out vec4 o_color;

bool keeps_lower_half() { return FORMAT != RG8 && FORMAT != RG16; }

// Returns x rounded to half precision: eleven significant bits, ties to even.
float half_of(float x) {
    float exponent = max(floor(log2(max(abs(x), 1e-9))), -14.0), unit = exp2(exponent - 10.0);
    return roundEven(x / unit) * unit;
}

vec3 stored(vec3 normal) {
#if FORMAT == UNORM8
    return encode_unorm8(normal);
#elif FORMAT == TRUNCATED
    return floor(255.0 * (0.5 * normal + 0.5));
#elif FORMAT == SNORM8
    return floor(127.0 * normal + 0.5);
#elif FORMAT == PAIRED8
    return encode_paired8(normal);
#elif FORMAT == RG8
    return vec3(encode_unorm8(vec3(normal.xy, 0.0)).xy, 0.0);
#elif FORMAT == RG16
    return vec3(floor(65535.0 * (0.5 * normal.xy + 0.5) + 0.5), 0.0);
#elif FORMAT == OCTAHEDRAL
    return vec3(floor(127.0 * encode_octahedral(normal) + 0.5), 0.0);
#else
    return vec3(half_of(normal.x), half_of(normal.y), half_of(normal.z));
#endif
}

// Returns the code as a texture with the bits of the format stores it: rounded and clamped.
vec3 whole(vec3 code) {
#if FORMAT == HALF
    return code;
#elif FORMAT == RG16
    return clamp(floor(code + 0.5), 0.0, 65535.0);
#elif FORMAT == SNORM8 || FORMAT == OCTAHEDRAL
    return clamp(floor(code + 0.5), -128.0, 127.0);
#else
    return clamp(floor(code + 0.5), 0.0, 255.0);
#endif
}

// Returns a texel. Its alpha is 1 if there is a direction, plus 2 if the encoder is unfinished.
vec4 texel_of(vec3 code, bool is_there) {
    return vec4(whole(code), float(is_there) + (is_unfinished ? 2.0 : 0.0));
}

vec4 texel_here() {
    vec4 texel = texelFetch(s_codes, ivec2(gl_FragCoord.xy), 0);
    if (texel.a >= 2.0) is_unfinished = true;
    return texel;
}

vec3 read_back(vec3 code) {
#ifdef MISMATCH
#define UNSIGNED_DECODER (FORMAT == PAIRED8)
#define PAIRED_DECODER (FORMAT == UNORM8 || FORMAT == TRUNCATED)
#else
#define UNSIGNED_DECODER (FORMAT == UNORM8 || FORMAT == TRUNCATED)
#define PAIRED_DECODER (FORMAT == PAIRED8)
#endif
#if UNSIGNED_DECODER
    return decode_unorm8(code);
#elif PAIRED_DECODER
    return decode_paired8(code);
#elif FORMAT == SNORM8
    return max(code / 127.0, -1.0);
#elif FORMAT == RG8
    vec2 xy = decode_unorm8(vec3(code.xy, 0.0)).xy;
    return vec3(xy, z_from_xy(xy));
#elif FORMAT == RG16
    vec2 xy = code.xy / 65535.0 * 2.0 - 1.0;
    return vec3(xy, z_from_xy(xy));
#elif FORMAT == OCTAHEDRAL
    return decode_octahedral(max(code.xy / 127.0, vec2(-1.0)));
#else
    return code;
#endif
}

float angle_degrees(vec3 a, vec3 b) { return degrees(atan(length(cross(a, b)), dot(a, b))); }

#ifdef MEASURE
// Returns the direction of this pixel. All pixels together cover the sphere evenly (Fibonacci): z has equal steps, and
// the angle steps by the golden ratio, whose multiples wrap exactly in 32-bit integers.
//(spread
vec3 spread_direction() {
    uint index = uint(gl_FragCoord.y) * uint(u_measured.x) + uint(gl_FragCoord.x);
    float share = (float(index) + 0.5) / float(u_measured.x * u_measured.y);
    float z = keeps_lower_half() ? 1.0 - 2.0 * share : share, rho = sqrt(max(0.0, 1.0 - z * z));
    float turn = float((index * 2654435769u) >> 8) / 16777216.0 * 6.28318531;
    return vec3(rho * cos(turn), rho * sin(turn), z);
}
//)

void main() {
#ifdef STORE
    o_color = texel_of(stored(spread_direction()), true);
#else
    o_color = measured(vec4(angle_degrees(read_back(texel_here().xyz), spread_direction()), 0.0, 0.0, 1.0));
#endif
}
#elif defined PROBE_normal && !defined STORE
void main() {
    vec4 texel = texel_here();
    if (mod(texel.a, 2.0) == 0.0) discard;
    o_color = probed(vec4(read_back(texel.xyz), 0.0));
}
#else

vec3 background(float y) { return mix(vec3(0.075, 0.08, 0.095), vec3(0.15, 0.16, 0.185), 0.5 + 0.5 * y); }

void main() {
    vec3 direction = normalize(u_forward + v_clip.x * u_right + v_clip.y * u_up);
    float along = -dot(u_eye, direction);
    vec3 nearest = u_eye + along * direction;
    float inside = 1.0 - dot(nearest, nearest);
    vec3 normal = normalize(nearest - sqrt(max(inside, 0.0)) * direction);
    bool missing = !keeps_lower_half() && normal.z < 0.0;
#ifdef PROBE_stored
    if (inside < 0.0 || missing) discard;
    o_color = probed(vec4(stored(normal), 0.0));
#elif defined STORE
    o_color = texel_of(stored(normal), inside >= 0.0 && !missing);
#else
    // The outline is antialiased over one pixel.
    float distance_ = sqrt(dot(nearest, nearest));
    float cover = clamp((1.0 - distance_) / max(fwidth(distance_), 1e-6) + 0.5, 0.0, 1.0);
    vec3 back = background(v_clip.y), color = back;
    if (cover > 0.0) {
        vec3 result = normalize(read_back(texel_here().xyz));
        if (missing) {
            bool odd = mod(floor((gl_FragCoord.x + gl_FragCoord.y) / 6.0), 2.0) == 1.0;
            color = odd ? vec3(0.20, 0.21, 0.23) : vec3(0.16, 0.17, 0.19);
        } else if (v_clip.x > u_split) {
            color = log_heat(angle_degrees(result, normal), -3.0, 1.0);
        } else {
            // A mirror among strips of light, since a reflection doubles the angular error of a normal.
            vec3 mirrored = reflect(direction, result), albedo = vec3(0.42, 0.15, 0.08);
            float above = dot(mirrored, normalize(u_up)), strips = sin(22.0 * above) * 6.0;
            float facing = 1.0 + dot(direction, result), shine = 0.06 + 0.94 * facing * facing * facing * facing * facing;
            vec3 light = albedo * mix(vec3(0.16, 0.15, 0.15), vec3(0.95, 0.98, 1.0), 0.5 + 0.5 * dot(result, normalize(u_up - 0.7 * u_right - u_forward)));
            light += (shine + 0.10) * clamp(0.5 + strips, 0.0, 1.0) * mix(vec3(0.9, 0.75, 0.6), vec3(0.8, 0.92, 1.1), 0.5 + 0.5 * above);
            color = srgb_from_linear(light);
        }
    }
    o_color = finished(vec4(mix(back, color, cover), 1.0), gl_FragCoord.xy);
#endif
}
#endif
