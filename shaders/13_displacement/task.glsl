// Lab 13, yours: a patch that is pressed in by a height map, and its normal.

#include "common/unfinished.glsl"

// TASK 13.1 (3 points): where a vertex goes. Height 1 stays on the base, height 0 lies `scale` metres inside:
// p' = p + scale (h - 1) n. `direction` is what interpolation leaves of the unit normals at the corners: it points outwards,
// but is no longer of length 1. read_height() reads the red channel of the map at a level; the stage that makes vertices
// has no neighbours to derive one from, so it must be named (textureLod).
float read_height(sampler2D heights, vec2 uv, float level) {
    //[solution
    return textureLod(heights, uv, level).r;
    //]starter
    //| return unfinished(1.0);
    //]
}

//(displaced
vec3 displaced(vec3 position, vec3 direction, float height, float scale) {
    //[solution
    return position + scale * (height - 1.0) * normalize(direction);
    //]starter
    //| return unfinished(position);
    //]
}
//)

// TASK 13.2 (3 points): which mip level a vertex reads. Where an edge that is `texels` long is cut into `segments`, a vertex
// stands for texels / segments of them: read the level whose texels are that wide. Level k has texels of 2^k; between two
// whole levels the texture unit blends, so fractions stay. Level 0 is the finest that there is: never give less than 0.
float height_level(float texels, float segments) {
    //[solution
    return max(log2(texels / segments), 0.0);
    //]starter
    //| return unfinished(0.0);
    //]
}

// TASK 13.3 (3 points): dh/du and dh/dv, per tile: half the difference between the heights one texel of this level further
// on and one texel back, over what a texel is in u (in v). `size` is that of level 0; a texel of level k is 2^k as wide.
vec2 height_slope(sampler2D heights, vec2 uv, float level, vec2 size) {
    //[solution
    vec2 texel = exp2(level) / size;
    return vec2(read_height(heights, uv + vec2(texel.x, 0.0), level) - read_height(heights, uv - vec2(texel.x, 0.0), level),
                read_height(heights, uv + vec2(0.0, texel.y), level) - read_height(heights, uv - vec2(0.0, texel.y), level)) /
           (2.0 * texel);
    //]starter
    //| return unfinished(vec2(0.0));
    //]
}

// TASK 13.4 (4 points): the unit normal of the displaced surface p'(u, v) = p + d n with d = scale (h - 1): at right angles to
// both dp'/du and dp'/dv. By the product rule dp'/du = du + d normal_du + scale slope.x normal, and the same along v: du and
// dv are dp/du and dp/dv of the base, `normal` is its unit normal, which turns by normal_du and normal_dv as u and v grow,
// and slope is dh/du, dh/dv. Where the uv are mirrored (or the relief reaches past the centre that the base bends around)
// the cross product points inwards: turn it. Where it is exactly 0 there is no such normal: take `normal`.
//(normal
vec3 displaced_normal(vec3 du, vec3 dv, vec3 normal, vec3 normal_du, vec3 normal_dv, float height, vec2 slope,
                      float scale) {
    //[solution
    float depth = scale * (height - 1.0);
    vec3 across = cross(du + depth * normal_du + scale * slope.x * normal, dv + depth * normal_dv + scale * slope.y * normal);
    float side = dot(across, normal) < 0.0 ? -1.0 : 1.0, squared = dot(across, across);
    return squared > 0.0 ? side * inversesqrt(squared) * across : normal;
    //]starter
    //| return unfinished(normal);
    //]
}
//)
