// Lab 13, your tasks: a patch that is displaced by a height map, and its normal.

#include "common/unfinished.glsl"

// TASK 13.1 (3 points): displace a vertex. Height 1 is on the base, height 0 lies `scale` metres inside: p' = p +
// scale (h - 1) n. `direction` is interpolated between the normals at the corners: it points outwards, but is no
// longer of unit length. read_height() reads the red channel of the map at a mip level. The evaluation shader has no
// neighbouring pixels to choose a level from, so pass it yourself (textureLod).
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

// TASK 13.2 (3 points): which mip level a vertex reads. An edge that is `texels` long is divided into `segments`, so a
// vertex stands for texels / segments texels: read the level whose texels are that wide. Level k has texels of width
// 2^k. Between two whole levels the texture unit blends, so do not round. Level 0 is the finest: never return less
// than 0.
float height_level(float texels, float segments) {
    //[solution
    return max(log2(texels / segments), 0.0);
    //]starter
    //| return unfinished(0.0);
    //]
}

// TASK 13.3 (3 points): dh/du and dh/dv, per tile. Take the difference between the heights one texel of this level
// further on and one texel back, and divide it by twice the width of a texel in u (in v). `size` is that of level 0; a
// texel of level k is 2^k times as wide.
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

// TASK 13.4 (4 points): the normal of the displaced surface p'(u, v) = p + d n with d = scale (h - 1), of unit length:
// it is perpendicular to both dp'/du and dp'/dv. By the product rule dp'/du = du + d normal_du + scale slope.x normal,
// and the same along v. du and dv are dp/du and dp/dv of the base, `normal` is its normal, normal_du and normal_dv are
// the derivatives of that normal, and slope is dh/du, dh/dv. Where the uv are mirrored (or the relief reaches past the
// centre of the base's curvature) the cross product points inwards: flip it. Where it is exactly 0 there is no such
// normal: return `normal`.
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
