#version 410 core
// A normal map from a height map. Alpha is 0 if a task is not written yet.
//
// A slope is a sum of weighted differences. Their texels and weights come from the CPU, so that both share one
// definition. They are a table with a row for each texel of a line, since the weights differ at a border that does not
// wrap.

#include "common/unfinished.glsl"
#include "03_height_to_normal/task.glsl"

uniform sampler2D s_heights;
uniform sampler2D s_differences_u;  // x and y: the texels along the line, z: the weight of h(x) - h(y)
uniform sampler2D s_differences_v;
uniform int u_differences;
uniform float u_beside;  // weight of each neighbouring line
uniform bool u_wrap;
uniform vec2 u_texels;

layout(location = 0) out vec4 o_normal;

ivec2 inside(ivec2 texel) {
    ivec2 size = textureSize(s_heights, 0);
    return u_wrap ? (texel + 2 * size) % size : clamp(texel, ivec2(0), size - 1);
}
float height(ivec2 texel) { return texelFetch(s_heights, inside(texel), 0).r; }

//(sum-of-differences
float slope_u(ivec2 texel) {
    float sum = 0.0;
    for (int i = 0; i < u_differences; ++i) {
        vec3 difference = texelFetch(s_differences_u, ivec2(i, texel.x), 0).xyz;
        sum += difference.z * (height(ivec2(difference.x, texel.y)) - height(ivec2(difference.y, texel.y)));
    }
    return sum;
}
//)
float slope_v(ivec2 texel) {
    float sum = 0.0;
    for (int i = 0; i < u_differences; ++i) {
        vec3 difference = texelFetch(s_differences_v, ivec2(i, texel.y), 0).xyz;
        sum += difference.z * (height(ivec2(texel.x, difference.x)) - height(ivec2(texel.x, difference.y)));
    }
    return sum;
}

#ifdef SOBEL
// Returns a height that may lie beyond a border that does not wrap. Along the slope the parabola through the last three
// texels continues. So a central difference becomes a one-sided one of the same order. Across the slope the border
// repeats.
//(beyond
float beyond(ivec2 texel, ivec2 along) {
    ivec2 size = textureSize(s_heights, 0), last = inside(texel);
    ivec2 inwards = (last - texel) * along;  // one step back along the slope, or none
    if (u_wrap || inwards == ivec2(0) || size.x < 3 || size.y < 3) return height(texel);
    return 3.0 * height(last) - 3.0 * height(last + inwards) + height(last + 2 * inwards);
}
//)
vec2 slope(ivec2 texel) {
    float for_u[9], for_v[9];
    for (int i = 0; i < 9; ++i) {
        ivec2 neighbour = texel + ivec2(i % 3 - 1, i / 3 - 1);
        for_u[i] = beyond(neighbour, ivec2(1, 0));
        for_v[i] = beyond(neighbour, ivec2(0, 1));
    }
    return vec2(sobel(for_u).x, sobel(for_v).y);
}
#else
vec2 slope(ivec2 texel) {
    vec2 here = vec2(slope_u(texel), slope_v(texel));
    if (u_beside == 0.0) return here;
    vec2 beside = vec2(slope_u(inside(texel + ivec2(0, 1))) + slope_u(inside(texel - ivec2(0, 1))),
                       slope_v(inside(texel + ivec2(1, 0))) + slope_v(inside(texel - ivec2(1, 0))));
    return here + u_beside * (beside - 2.0 * here);
}
#endif

void main() {
    vec3 normal = normal_of_slope(slope(ivec2(gl_FragCoord.xy)), u_texels);
    o_normal = vec4(normal, is_unfinished ? 0.0 : 1.0);
}
