#version 410 core
// One mip level of a mask, drawn at one pixel per texel and magnified; or its coverage.

#include "common/unfinished.glsl"
#include "08_obj_materials/task.glsl"
#include "common/srgb.glsl"

in vec2 v_clip;

uniform sampler2D s_mask;
uniform int u_level;
uniform float u_scale;
uniform float u_threshold;
uniform float u_part;  // part of the mask that is shown

layout(location = 0) out vec4 o_color;

float share(float alpha, float change) {
#if defined ALPHA_TEST
    return alpha > u_threshold ? 1.0 : 0.0;
#elif defined ALPHA_KEEP
    return covered(alpha, change, u_scale) >= 0.5 ? 1.0 : 0.0;
#elif defined ALPHA_TO_COVERAGE
    return covered(alpha, change, u_scale);
#else
    return alpha;  // on average
#endif
}

float share_at(vec2 uv) {
    vec2 texel = 1.0 / vec2(textureSize(s_mask, u_level));
    float alpha = textureLod(s_mask, uv, float(u_level)).r;
    float change = abs(textureLod(s_mask, uv + vec2(texel.x, 0.0), float(u_level)).r - alpha) +
                   abs(textureLod(s_mask, uv + vec2(0.0, texel.y), float(u_level)).r - alpha);
    return share(alpha, change);
}

void main() {
#if defined PROBE_coverage || defined MEASURE
    // Evenly distributed places, between texels, too (Roberts 2018).
    float sum = 0.0;
    for (int i = 0; i < 4096; ++i)
        sum += share_at(fract((float(i) + 0.5) * vec2(0.7548776662, 0.5698402910)));
    vec4 share = vec4(sum / 4096.0, 0.0, 0.0, 0.0);
#ifdef MEASURE
    share = measured(share);
#endif
    o_color = share;
#else
    vec2 size = vec2(textureSize(s_mask, u_level)), uv = u_part * (0.5 + 0.5 * v_clip);
    // A pixel's centre may lie on the border of two texels. The small offset chooses one, independent of rounding.
    float cover = share_at((floor(uv * size + 1.0 / 2048.0) + 0.5) / size);
    vec3 light = mix(vec3(0.012, 0.016, 0.03), vec3(0.75, 0.68, 0.55), cover);
    o_color = finished(vec4(srgb_from_linear(light), 1.0), gl_FragCoord.xy);
#endif
}
