// Lab 10, your tasks: the view ray in a relief, and three ways to estimate where it meets the surface. Height 1 is the
// surface that is drawn, and height 0 lies as deep as the relief. Along the ray t runs from 0, at height 1, to 1, at
// height 0.

#include "common/unfinished.glsl"

// The least slant: a flatter ray would cross more tiles than a float can distinguish.
const float least_slant = 0.002;

// TASK 10.1 (3 points): by how much does uv change while the view ray goes down from height 1 to height 0? `to_eye`,
// `tangent`, `bitangent` and `normal` are world-space directions of unit length, the last three at right angles.
// `depth` is the depth of the relief, in tiles along u and along v (two numbers: a tile need not be square). Transform
// `to_eye` to tangent space; the ray goes the opposite way. While it goes down by 1, it goes sideways by xy / z. Use
// max(z, least_slant) for z.
//(ray
vec2 ray_in_relief(vec3 to_eye, vec3 tangent, vec3 bitangent, vec3 normal, vec2 depth) {
    //[solution
    vec3 seen = vec3(dot(to_eye, tangent), dot(to_eye, bitangent), dot(to_eye, normal));
    return -seen.xy / max(seen.z, least_slant) * depth;
    //]starter
    //| return unfinished(vec2(0.0));
    //]
}
//)

// TASK 10.2 (2 points): the coordinate of the ray at t; `along` is the result of 10.1. And a first estimate of t
// (Kaneko et al. 2001): as if the relief were everywhere as high as it is where the ray enters it.
vec2 on_ray(vec2 uv, vec2 along, float t) {
    //[solution
    return uv + t * along;
    //]starter
    //| return unfinished(uv);
    //]
}

float offset_t(float height) {
    //[solution
    return 1.0 - height;
    //]starter
    //| return unfinished(0.0);
    //]
}

// TASK 10.3 (2 points): offset limiting (Welsh 2004): the same without the division by z, so that the offset is never
// longer than the relief is deep. `along` is already divided; `slant` is the divisor.
float limited_t(float height, float slant) {
    //[solution
    return (1.0 - height) * slant;
    //]starter
    //| return unfinished(0.0);
    //]
}

// TASK 10.4 (4 points): steep parallax (McGuire and McGuire 2005): go down the ray in `steps` layers, t = 0, 1/steps,
// 2/steps, ... and stop at the first t at which the ray, at height 1 - t, is not above the surface. At t = 1 it never
// is. Read heights by textureLod(heights, uv, 0.0).r: texture() computes its level from neighbouring pixels, which may
// have left the loop.
//(steep
float steep_t(sampler2D heights, vec2 uv, vec2 along, int steps) {
    //[solution
    for (int layer = 0; layer < steps; ++layer) {
        float t = float(layer) / float(steps);
        if (1.0 - t <= textureLod(heights, on_ray(uv, along, t), 0.0).r) return t;
    }
    return 1.0;
    //]starter
    //| return unfinished(0.0);
    //]
}
//)
