#version 410 core
// The surfaces of the court: the light of the sky, of the lamps and of the mirrored sky, each with its occlusion.

#include "16_environment/ground.glsl"
#include "16_environment/sky.glsl"
#include "common/unfinished.glsl"
#include "16_environment/task.glsl"
#include "common/srgb.glsl"

in vec3 v_position;
in vec3 v_normal;
in vec3 v_tangent;
in vec2 v_uv;
in vec4 v_clip;

uniform sampler2D s_albedo;
uniform sampler2D s_normals;
uniform sampler2D s_packed;
uniform sampler2D s_open;
uniform sampler2DShadow s_shadow;

uniform vec3 u_eye;
uniform float u_roughness;
uniform float u_exponent;     // of a gloss of 1
uniform float u_side;         // texels along an edge of the sky's cube map
uniform vec3 u_ambient[2];    // from below, from above
uniform vec3 u_lamp_color[3];
uniform vec3 u_lamp_place[3]; // position; of the first, the sun, the direction to it
uniform mat3 u_light_from_world;
uniform mat4 u_light_clip_from_world;
uniform vec3 u_shadow;        // metres: a texel's width, range of depths; rounding, in depths
uniform int u_pcf;

#ifdef TERMS
layout(location = 0) out vec4 o_ambient;
layout(location = 1) out vec4 o_lamps;
layout(location = 2) out vec4 o_mirror;
layout(location = 3) out vec4 o_light;
#else
layout(location = 0) out vec4 o_color;
#endif

vec4 read_map(sampler2D map, vec2 uv) {
#ifdef LEVEL_0
    // Filters level 0 in floats, since a driver's filter may have weights of 8 bits.
    ivec2 size = textureSize(map, 0);
    vec2 place = fract(uv) * vec2(size) - 0.5, low = floor(place), part = place - low;
    ivec2 a = (ivec2(low) + size) % size, b = (a + 1) % size;
    return mix(mix(texelFetch(map, a, 0), texelFetch(map, ivec2(b.x, a.y), 0), part.x),
               mix(texelFetch(map, ivec2(a.x, b.y), 0), texelFetch(map, b, 0), part.x), part.y);
#else
    return texture(map, uv);
#endif
}

// The inputs of the lighting at a place. `straight` is the mirrored share at normal incidence.
struct Surface {
    vec3 face, normal, albedo;
    float gloss, occlusion, straight, exponent;
};

Surface surface_at() {
    Surface surface;
    surface.face = normalize(v_normal);
#ifdef FLOOR
    vec3 ground = ground_at(v_position.xz);
#endif
#ifdef DISPLACED
    vec3 rise = floor_at(ground);
    surface.face = normalize(vec3(-rise.y, 1.0, -rise.z));
#endif
    vec3 tangent = normalize(v_tangent - dot(v_tangent, surface.face) * surface.face);
    vec3 bump = read_map(s_normals, v_uv).xyz * 2.0 - 1.0, maps = read_map(s_packed, v_uv).rgb;
    surface.albedo = read_map(s_albedo, v_uv).rgb;
#ifdef FLOOR
    // Water covers the lowest ground, joints first. Its surface is smooth, and the ground below it is darker.
    float depth = u_water - ground.x + 0.5 * (0.6 - maps.g);
    float wet = smoothstep(0.0, 0.12, depth), damp = smoothstep(-0.35, 0.05, depth);
    bump = mix(bump, vec3(0.0, 0.0, 1.0), wet);
    maps = mix(maps, vec3(1.0, maps.g, 1.0), vec3(max(wet, 0.3 * damp), 0.0, wet));
    surface.albedo *= mix(1.0, 0.55, damp) * mix(1.0, 0.45, wet);
    surface.straight = mix(0.04, 0.02, wet);
#else
    surface.straight = 0.04;
#endif
    surface.normal = normalize(mat3(tangent, cross(surface.face, tangent), surface.face) * bump);
    surface.gloss = maps.r;
    surface.occlusion = maps.b;
#if defined GLOSS_EVEN
    surface.gloss = 1.0;
    surface.exponent = u_exponent;
#elif defined GLOSS_MIRROR
    surface.exponent = u_exponent;
#else
    surface.exponent = sharpness(maps, u_roughness, u_exponent);
#endif
    return surface;
}

float mirrored_share(float straight, float cosine) {
#if defined FRESNEL_WHOLE
    return 1.0;
#elif defined FRESNEL_EXACT
    float eta = (1.0 + sqrt(straight)) / (1.0 - sqrt(straight)), c = clamp(cosine, 0.0, 1.0);
    float within = sqrt(1.0 - (1.0 - c * c) / (eta * eta));
    float s = (c - eta * within) / (c + eta * within), p = (within - eta * c) / (within + eta * c);
    return 0.5 * (s * s + p * p);
#else
    return fresnel(straight, cosine);
#endif
}

// ---- shadow and occlusion

float shadow_at(Surface surface) {
#ifdef SHADOW
    vec3 normal = u_light_from_world * surface.face;
    if (normal.z <= 0.0) return 0.0;
    float bias = 0.0;
#if defined BIAS_CONSTANT
    bias = u_shadow.x;
#elif defined BIAS_PLANE
    // The plane is that of the triangle, which on a round shape differs from the plane of the interpolated normal.
    vec3 plane = u_light_from_world * cross(dFdx(v_position), dFdy(v_position));
    plane *= inversesqrt(max(dot(plane, plane), 1e-24));
    bias = shadow_bias(plane.z < 0.0 ? -plane : plane, u_shadow.x, u_pcf);
#endif
    return lit(s_shadow, u_light_clip_from_world * vec4(v_position, 1.0), bias / u_shadow.y + u_shadow.z, u_pcf);
#else
    return 1.0;
#endif
}

// Returns the occlusion from the four nearest texels of the smaller picture. Texels at about this distance ahead have
// most of the weight.
float open_at() {
#ifdef AO
    vec2 size = vec2(textureSize(s_open, 0)), place = (v_clip.xy / v_clip.w * 0.5 + 0.5) * size - 0.5;
    vec2 corner = floor(place) + 1.0, part = place - floor(place);  // common corner of the four texels
    vec4 shares = textureGather(s_open, corner / size, 0), ahead = textureGather(s_open, corner / size, 1);
    // The order of textureGather(): above left, above right, below right, below left.
    vec4 near = vec4(1.0 - part.x, part.x, part.x, 1.0 - part.x) * vec4(part.y, part.y, 1.0 - part.y, 1.0 - part.y);
    vec4 weights = (near + 1e-3) * (clamp(1.0 - 20.0 * abs(ahead - v_clip.w) / v_clip.w, 0.0, 1.0) + 1e-4);
    if (any(lessThan(shares, vec4(0.0)))) is_unfinished = true;
    return dot(weights, shares) / dot(weights, vec4(1.0));
#else
    return 1.0;
#endif
}

float occlusion_at(Surface surface) {
#ifdef OCCLUSION
    return open_at() * surface.occlusion;
#else
    return open_at();
#endif
}

//(mirror-open
// Returns a guess of the share of the mirrored lobe that nothing hides, where `open` is the share of the sky.
float mirror_open(Surface surface, vec3 to_eye, vec3 normal, float open) {
#if defined MIRROR_AS_SKY
    return open;
#elif defined MIRROR_LAGARDE
    // Lagarde and de Rousiers 2014. A half vector's exponent is four times that of a mirrored direction.
    float alpha = inversesqrt(2.0 * surface.exponent + 1.0), facing = clamp(dot(normal, to_eye), 0.0, 1.0);
    return clamp(pow(facing + open, exp2(-16.0 * alpha - 1.0)) - 1.0 + open, 0.0, 1.0);
#else
    return 1.0;
#endif
}
//)

// ---- the lights

vec3 ambient_at(Surface surface) { return surface.albedo * mix(u_ambient[0], u_ambient[1], 0.5 + 0.5 * surface.normal.y); }

// Returns the light of a lamp of strength 1. A half vector's exponent is four times that of a mirrored direction.
vec3 lamp_at(Surface surface, vec3 to_light, vec3 to_eye) {
    float facing = max(dot(surface.normal, to_light), 0.0), exponent = 4.0 * surface.exponent;
    vec3 between = to_light + to_eye;
    between *= inversesqrt(max(dot(between, between), 1e-12));
    float lobe = exp2(exponent * log2(max(dot(surface.normal, between), 1e-6)));
    float share = surface.gloss * mirrored_share(surface.straight, dot(between, to_light));
    return facing * (surface.albedo + share * (exponent + 8.0) / 8.0 * lobe);
}

vec3 lamps_at(Surface surface, vec3 to_eye, float shadow) {
    vec3 sum = shadow * u_lamp_color[0] * lamp_at(surface, u_lamp_place[0], to_eye);
    for (int i = 1; i < LAMPS; ++i) {
        vec3 way = u_lamp_place[i] - v_position;
        float square = dot(way, way);
        sum += u_lamp_color[i] / max(square, 0.01) * lamp_at(surface, way * inversesqrt(max(square, 1e-8)), to_eye);
    }
    return sum;
}

vec3 mirrored_sky(Surface surface, vec3 to_eye, vec3 normal) {
    float level = 0.0;
#ifndef GLOSS_MIRROR
    level = blur_level(surface.exponent, u_side);
#endif
    return sky_at(mirrored(to_eye, normal, surface.face), level);
}

float share_at(Surface surface, vec3 to_eye, vec3 normal) {
    return surface.gloss * mirrored_share(surface.straight, dot(normal, to_eye));
}

vec4 shown(vec3 value) { return finished(vec4(srgb_from_linear(value), 1.0), gl_FragCoord.xy); }

void main() {
    Surface surface = surface_at();
    vec3 to_eye = normalize(u_eye - v_position);
    vec3 mirror_normal = surface.normal;
#ifdef LIGHT_ONLY
    mirror_normal = surface.face;
#endif
#if defined PROBE_normal
    o_color = probed(vec4(surface.normal, 0.0));
#elif defined PROBE_reflection
    o_color = probed(vec4(mirrored_sky(surface, to_eye, mirror_normal), 0.0));
#elif defined PROBE_fresnel
    o_color = probed(vec4(mirrored_share(surface.straight, dot(mirror_normal, to_eye)), 0.0, 0.0, 0.0));
#elif defined PROBE_exponent
    o_color = probed(vec4(surface.exponent, 0.0, 0.0, 0.0));
#elif defined PROBE_shadow
    o_color = probed(vec4(shadow_at(surface), 0.0, 0.0, 0.0));
#elif defined PROBE_occlusion
    o_color = probed(vec4(open_at(), 0.0, 0.0, 0.0));
#elif defined PROBE_mirror_open
    o_color = probed(vec4(mirror_open(surface, to_eye, mirror_normal, open_at()), 0.0, 0.0, 0.0));
#elif defined SHOW_ambient
    o_color = shown(exposed(ambient_at(surface)));
#elif defined SHOW_lamps
    o_color = shown(exposed(lamps_at(surface, to_eye, 1.0)));
#elif defined SHOW_reflection
    o_color = shown(exposed(mirrored_sky(surface, to_eye, mirror_normal)));
#elif defined SHOW_occlusion
    o_color = shown(vec3(occlusion_at(surface)));
#elif defined SHOW_shadow
    o_color = shown(vec3(shadow_at(surface)));
#elif defined SHOW_share
    o_color = shown(vec3(share_at(surface, to_eye, mirror_normal)));
#else
    float shadow = shadow_at(surface), occlusion = occlusion_at(surface);
    vec3 ambient = ambient_at(surface), lamps = lamps_at(surface, to_eye, shadow), mirror = vec3(0.0);
    float share = share_at(surface, to_eye, mirror_normal);
#ifdef REFLECTION
    mirror = share * mirrored_sky(surface, to_eye, mirror_normal);
#if defined MIRROR_AS_SKY || defined MIRROR_LAGARDE
    mirror *= mirror_open(surface, to_eye, mirror_normal, occlusion);
#endif
#endif
    vec3 light = sum_of_light(ambient, lamps, mirror, occlusion);
#if defined TERMS
    o_ambient = vec4(ambient, occlusion);
    o_lamps = vec4(lamps, shadow);
    o_mirror = vec4(mirror, share);
    o_light = vec4(light, is_unfinished ? 1.0 : 0.0);
#elif defined PROBE_light
    o_color = probed(vec4(light, 0.0));
#else
    o_color = shown(exposed(light));
#endif
#endif
}
