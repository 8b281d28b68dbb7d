#version 410 core
// The map on the wall: lit, or its error compared with the normal of the known function.

#include "common/heat.glsl"
#include "common/light.glsl"
#include "common/srgb.glsl"
#include "common/unfinished.glsl"

in vec3 v_position;
in vec2 v_uv;

uniform sampler2D s_normals;
uniform sampler2D s_heights;
uniform vec3 u_eye;
uniform vec3 u_light;
#ifdef ERROR
uniform sampler2D s_truth;
uniform float u_split;  // in shares of the wall's width
uniform float u_repeat;
#endif

#ifdef DERIVED
uniform sampler2D s_derived;  // one value per texel
#endif

layout(location = 0) out vec4 o_color;

ivec2 texel() {
    ivec2 size = textureSize(s_normals, 0);
    return clamp(ivec2(fract(v_uv) * vec2(size)), ivec2(0), size - 1);
}

void main() {
#if defined PROBE_normal
    vec4 stored = texelFetch(s_normals, texel(), 0);
    is_unfinished = stored.a < 0.5;
    o_color = probed(vec4(stored.xyz, 0.0));
#elif defined PROBE_height
    o_color = vec4(texelFetch(s_heights, texel(), 0).r, 0.0, 0.0, 0.0);
#else
    vec4 stored = texture(s_normals, v_uv);
    is_unfinished = stored.a < 0.5;
    vec3 color;
#ifdef DERIVED
    color = texture(s_derived, v_uv).rrr;
#else
#ifdef ERROR
    if (v_uv.x > u_split * u_repeat) {
        vec3 a = texelFetch(s_normals, texel(), 0).xyz, b = texelFetch(s_truth, texel(), 0).xyz;
        float error = degrees(atan(length(cross(a, b)), dot(a, b)));
        color = log_heat(error, -3.0, 1.0);
    } else
#endif
    {
        vec3 normal = normalize(stored.xyz), to_eye = normalize(u_eye - v_position), albedo = vec3(0.47, 0.39, 0.31);
        vec3 light = albedo * mix(vec3(0.07, 0.065, 0.06), vec3(0.14, 0.16, 0.19), 0.5 + 0.5 * normal.y);
        light += vec3(1.25, 1.12, 0.95) * blinn_phong(albedo, 0.05, 60.0, normal, normalize(u_light - v_position), to_eye);
        color = srgb_from_linear(light);
    }
#endif
    o_color = finished(vec4(color, 1.0), gl_FragCoord.xy);
#endif
}
