#version 410 core
// Encodes the light of a frame: from linear floats to the values that the target stores.

#include "common/srgb.glsl"
#include "common/unfinished.glsl"

#if SAMPLES > 1
uniform sampler2DMS s_light;
uniform sampler2DMS s_sum;
uniform sampler2DMS s_passed;
#else
uniform sampler2D s_light;
uniform sampler2D s_sum;
uniform sampler2D s_passed;
#endif

layout(location = 0) out vec4 o_color;

vec3 linear_from_srgb(vec3 stored) {
    vec3 positive = max(stored, 0.0);
    return mix(pow((positive + 0.055) / 1.055, vec3(2.4)), positive / 12.92, lessThanEqual(positive, vec3(0.04045)));
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 light = texelFetch(s_light, pixel, i).rgb;
#ifdef WEIGHTED
        // The weighted mean of all panes, over the light that passes through all of them (McGuire and Bavoil 2013).
        vec4 panes = texelFetch(s_sum, pixel, i);
        float passed = texelFetch(s_passed, pixel, i).r;
        if (panes.r < -1.0) is_unfinished = true;
        light = mix(panes.rgb / max(panes.a, 1e-5), light, passed);
#endif
        if (light.r < -1.0) is_unfinished = true;
        sum += light;
    }
    vec3 light = sum / float(SAMPLES);
#ifdef STORED
    light = linear_from_srgb(light);
#endif
#ifdef PROBE_color
    o_color = probed(vec4(light, 0.0));
#else
    // Compresses bright light, as film does.
    o_color = finished(vec4(srgb_from_linear(1.0 - exp(-1.7 * light)), 1.0), gl_FragCoord.xy);
#endif
}
