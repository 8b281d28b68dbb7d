#version 410 core
// A relief whose hit is estimated by METHOD: lit, or as the ERROR of the estimate.

#include "common/unfinished.glsl"
#include "10_parallax_offset/task.glsl"
#if defined ERROR || defined MEASURE
#include "common/exact_hit.glsl"
#endif
#include "common/heat.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"

// The order of `methods` in lab.cpp.
#define OFFSET 0
#define LIMITED 1
#define STEEP 2

in vec3 v_position;
in vec3 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

uniform vec3 u_eye;
uniform vec2 u_depth;  // of the relief, tiles along u and v
uniform float u_depth_metres;
uniform vec2 u_normal_strength;
uniform int u_steps;
uniform vec3 u_to_light;
uniform vec3 u_up;  // in the space of the normals
uniform sampler2D s_heights;
uniform sampler2D s_albedo;
uniform sampler2D s_normals;
uniform sampler2DArray s_windows;  // for the exact hit
uniform mat4 u_window_extent;

layout(location = 0) out vec4 o_color;

float guessed_t(vec2 along, float slant) {
#if METHOD == STEEP
    return steep_t(s_heights, v_uv, along, u_steps);
#elif METHOD == LIMITED
    return limited_t(textureLod(s_heights, v_uv, 0.0).r, slant);
#else
    return offset_t(textureLod(s_heights, v_uv, 0.0).r);
#endif
}

float taps(float t) { return METHOD == STEEP ? round(t * float(u_steps)) + 1.0 : 1.0; }

// Chooses mip levels by the undisplaced uv, since displaced uv jump where one brick hides another. The longer side of
// the footprint is clamped to four times the shorter one.
//(smaller-levels
vec4 seen_in(sampler2D map, vec2 uv) {
    vec2 dx = dFdx(v_uv), dy = dFdy(v_uv);
    float x = length(dx), y = length(dy);
    return textureGrad(map, uv, dx * min(1.0, 4.0 * y / max(x, 1e-20)), dy * min(1.0, 4.0 * x / max(y, 1e-20)));
}
//)

vec3 lit(mat3 frame, vec3 to_eye, vec2 uv) {
    vec3 stored = seen_in(s_normals, uv).xyz * 2.0 - 1.0;
    vec3 normal = normalize(frame * vec3(stored.xy * u_normal_strength, stored.z));
    vec3 albedo = seen_in(s_albedo, uv).rgb;
    float open = mix(0.45, 1.0, textureLod(s_heights, uv, 0.0).r);  // the depths see less of the sky
    vec3 light = open * albedo * mix(vec3(0.10, 0.09, 0.08), vec3(0.26, 0.30, 0.37), 0.5 + 0.5 * dot(normal, u_up));
    return light + vec3(1.7, 1.56, 1.36) * blinn_phong(albedo, 0.03, 24.0, normal, u_to_light, to_eye);
}

void main() {
    // Two cross products make an orthonormal frame that keeps the normal.
    vec3 normal = normalize(v_normal);
    vec3 bitangent = v_tangent.w * normalize(cross(normal, v_tangent.xyz));
    vec3 tangent = v_tangent.w * cross(bitangent, normal);
    vec3 to_eye = normalize(u_eye - v_position);
    float cosine = dot(to_eye, normal), slant = max(cosine, least_slant);

    //(search
    vec2 along = ray_in_relief(to_eye, tangent, bitangent, normal, u_depth);
    float t = cosine > 0.0 ? guessed_t(along, slant) : 0.0;  // no relief from behind
    vec2 uv = on_ray(v_uv, along, t);
    //)
#if defined PROBE_ray
    o_color = probed(vec4(along * vec2(textureSize(s_heights, 0)), 0.0, 0.0));
#elif defined PROBE_uv
    o_color = probed(vec4(uv * vec2(textureSize(s_heights, 0)), 0.0, 0.0));
#elif defined PROBE_depth
    o_color = probed(vec4(distance(u_eye, v_position) + t * u_depth_metres / slant, 0.0, 0.0, 0.0));
#elif defined PROBE_steps
    o_color = probed(vec4(taps(t), 0.0, 0.0, 0.0));
#elif defined ERROR || defined MEASURE
    float exact = cosine > 0.0 ? exact_hit(s_heights, s_windows, u_window_extent, v_uv, along, vec2(0.0, 1.0)) : 0.0;
    float texels = abs(t - exact) * length(along * vec2(textureSize(s_heights, 0)));
#ifdef MEASURE
    o_color = measured(vec4(texels, 0.0, 0.0, 0.0));
#else
    o_color = finished(vec4(log_heat(texels, -2.0, 2.0), 1.0), gl_FragCoord.xy);
#endif
#else
    o_color = finished(vec4(srgb_from_linear(lit(mat3(tangent, bitangent, normal), to_eye, uv)), 1.0), gl_FragCoord.xy);
#endif
}
