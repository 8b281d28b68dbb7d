#version 410 core
// A normal map on the square from -1 to 1 in the plane z = 0, as a texture gives it back: lit, compared with the map, or
// (TEXELS) as it is stored.

#include "common/unfinished.glsl"
#include "02_normal_map_storage/task.glsl"
#include "common/heat.glsl"
#include "common/srgb.glsl"

in vec2 v_clip;

uniform vec3 u_eye;
uniform vec3 u_forward;  // to the middle of the window; `right` and `up` lead from there to its edges
uniform vec3 u_right;
uniform vec3 u_up;
uniform vec3 u_part;      // the part of the map on the square: its lower left corner and its size, in uv
#ifdef TEXELS
uniform int u_channel;  // which channel is shown, or -1: all three
#endif
uniform float u_split;    // x in clip coordinates: lit to its left, the error to its right
uniform float u_borders;  // 1: lines between the blocks
uniform float u_tiles;    // tiles of the map along each side of the square, 1 or 2
uniform bool u_mirrored;  // the right and the upper tiles are mirrored
uniform sampler2D s_exact;
uniform sampler2D s_stored;

layout(location = 0) out vec4 o_color;

// Returns the texel in the steps of its channels.
vec3 stored(ivec2 texel) {
    vec3 value = texelFetch(s_stored, texel, 0).xyz;
#ifdef COLORS
    return 255.0 * value;
#elif defined TWO_SIGNED
    return vec3(127.0 * value.xy, 0.0);
#elif defined THREE_SIGNED || defined SIGNED_TWICE
    return 127.0 * value;
#elif defined CODES
    return floor(127.0 * texelFetch(s_exact, texel, 0).xyz + 0.5);
#else
    return vec3(255.0 * value.xy, 0.0);
#endif
}

vec3 read_back(ivec2 texel) {
#ifdef COLORS
    return stored(texel) / 127.5 - 1.0;
#elif defined TWO_SIGNED
    vec2 xy = stored(texel).xy / 127.0;
    return vec3(xy, z_from_xy(xy));
#elif defined THREE_SIGNED
    return texelFetch(s_stored, texel, 0).xyz;
#elif defined CODES
    return stored(texel) / 127.0;
#elif defined SIGNED_TWICE
    return 2.0 * texelFetch(s_stored, texel, 0).xyz - 1.0;
#else
    vec2 xy = stored(texel).xy / 127.5 - 1.0;
    return vec3(xy, z_from_xy(xy));
#endif
}

float error_degrees(ivec2 texel) {
    vec3 a = read_back(texel), b = texelFetch(s_exact, texel, 0).xyz;
    return degrees(atan(length(cross(a, b)), dot(a, b)));
}

#ifdef MEASURE
void main() { o_color = measured(vec4(error_degrees(ivec2(gl_FragCoord.xy)), 0.0, 0.0, 1.0)); }
#else

void main() {
    vec3 direction = normalize(u_forward + v_clip.x * u_right + v_clip.y * u_up);
    float t = -u_eye.z / direction.z;
    vec2 place = (u_eye + t * direction).xy;
    float outside = t > 0.0 ? max(abs(place.x), abs(place.y)) : 2.0;
    vec2 size = vec2(textureSize(s_exact, 0)), tiles = (0.5 * place + 0.5) * u_tiles;
    vec2 tile = clamp(floor(tiles), vec2(0.0), vec2(u_tiles - 1.0)), uv = tiles - tile;
    // A mirrored tile runs backwards, and its slopes along that axis have the other sign.
    vec2 turned = u_mirrored ? tile : vec2(0.0);
    uv = mix(uv, 1.0 - uv, turned);
    vec3 sign_ = vec3(1.0 - 2.0 * turned, 1.0);
    uv = u_part.xy + u_part.z * uv;
    ivec2 texel = clamp(ivec2(floor(uv * size)), ivec2(0), ivec2(size) - 1);
#ifdef PROBE_normal
    if (outside >= 1.0) discard;
    o_color = probed(vec4(sign_ * read_back(texel), 0.0));
#elif defined PROBE_stored
    if (outside >= 1.0) discard;
    o_color = vec4(stored(texel), 0.0);
#else
    // The outline is antialiased over one pixel.
    float cover = clamp((1.0 - outside) / max(fwidth(outside), 1e-6) + 0.5, 0.0, 1.0);
    vec3 back = mix(vec3(0.075, 0.08, 0.095), vec3(0.15, 0.16, 0.185), 0.5 + 0.5 * v_clip.y), color = back;
#ifdef TEXELS
    vec3 value = texelFetch(s_stored, texel, 0).xyz;
    if (cover > 0.0) color = u_channel < 0 ? value : vec3(value[u_channel]);
#else
    vec2 block = tiles * size / 4.0, pixel = fwidth(block);
    if (cover > 0.0 && v_clip.x > u_split) {
        color = log_heat(error_degrees(texel), -3.0, 1.0);
        vec2 distance_ = abs(fract(block - 0.5) - 0.5) / max(pixel, vec2(1e-6));
        float line = 1.0 - smoothstep(0.4, 1.2, min(distance_.x, distance_.y));
        float room = 1.0 - smoothstep(0.1, 0.25, max(pixel.x, pixel.y));  // no lines where blocks are a few pixels
        color = mix(color, vec3(0.45, 0.55, 0.60), 0.6 * line * room * u_borders);
    } else if (cover > 0.0) {
        vec3 normal = sign_ * normalize(read_back(texel)), light = normalize(vec3(-0.6, 0.55, 0.6));
        vec3 eye = -direction * (u_eye.z < 0.0 ? -1.0 : 1.0);
        float shine = pow(max(dot(normal, normalize(light + eye)), 0.0), 60.0);
        color = srgb_from_linear(vec3(0.42, 0.15, 0.08) * (0.06 + max(dot(normal, light), 0.0)) + 0.5 * shine);
    }
#endif
    o_color = finished(vec4(mix(back, color, cover), 1.0), gl_FragCoord.xy);
#endif
}
#endif
