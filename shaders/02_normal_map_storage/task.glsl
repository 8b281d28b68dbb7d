// Lab 02, your tasks: a normal as a few small integers, and back. Codes are whole numbers, as floats.

#include "common/unfinished.glsl"

// TASK 2.1 (3 points): f(x) = (0.5 x + 0.5) 255 maps x in [-1, 1] to [0, 255]. Store the nearest whole number (a cast
// truncates, which doubles the error). Then write the inverse of f.
//(bytes
vec3 encode_unorm8(vec3 normal) {
    //[solution
    return floor(255.0 * (0.5 * normal + 0.5) + 0.5);
    //]starter
    //| return unfinished(vec3(0.0));
    //]
}

vec3 decode_unorm8(vec3 code) {
    //[solution
    return code / 255.0 * 2.0 - 1.0;
    //]starter
    //| return unfinished(vec3(0.0));
    //]
}
//)

// TASK 2.2 (2 points): no code of 2.1 stands for 0, so a flat texel leans by a third of a degree. Write another pair:
// store x as 127 x + 128, rounded, so that 128 stands for 0 exactly; then write its inverse.
vec3 encode_paired8(vec3 normal) {
    //[solution
    return floor(127.0 * normal + 128.5);
    //]starter
    //| return unfinished(vec3(0.0));
    //]
}

vec3 decode_paired8(vec3 code) {
    //[solution
    return (code - 128.0) / 127.0;
    //]starter
    //| return unfinished(vec3(0.0));
    //]
}

// TASK 2.3 (2 points): two channels hold x and y of a normal of unit length that points out of the surface. What is z?
// Rounding can make (x, y) longer than 1: there z is 0, and never NaN.
float z_from_xy(vec2 xy) {
    //[solution
    return sqrt(max(0.0, 1.0 - dot(xy, xy)));
    //]starter
    //| return unfinished(0.0);
    //]
}

// TASK 2.4 (4 points): the octahedral map. Divide by |x| + |y| + |z|: the upper half of the octahedron, seen from
// above, is a square standing on its corner. Fold the lower half's triangles outwards over its edges. The sign of 0
// counts as 1. Both components of the result are in [-1, 1] (the framework stores them in two bytes). The decoded
// normal must have unit length.
vec2 signs(vec2 v) { return vec2(v.x >= 0.0 ? 1.0 : -1.0, v.y >= 0.0 ? 1.0 : -1.0); }

//(octahedral
vec2 encode_octahedral(vec3 normal) {
    //[solution
    vec2 p = normal.xy / (abs(normal.x) + abs(normal.y) + abs(normal.z));
    return normal.z >= 0.0 ? p : (1.0 - abs(p.yx)) * signs(p);
    //]starter
    //| return unfinished(vec2(0.0));
    //]
}
//)

//(octahedral-back
vec3 decode_octahedral(vec2 p) {
    //[solution
    vec3 normal = vec3(p, 1.0 - abs(p.x) - abs(p.y));
    if (normal.z < 0.0) normal.xy = (1.0 - abs(p.yx)) * signs(p);
    return normalize(normal);
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}
//)
