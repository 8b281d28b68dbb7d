// Lab 09, your tasks: directions on a cube sphere, and normals from heights on a grid that is bent and skewed. (Tasks 9.6
// and 9.7 are in labs/09_planet/task.cpp.)

#include "common/unfinished.glsl"

// TASK 9.1 (2 points): the direction from the planet's centre, of unit length, of the place (s, t) on a face of a cube,
// each from -1 to 1. The columns of `face` are its axes: to the right (growing s), up (growing t), and out. Lines of
// equal s, and of equal t, lie at equal angles: s = 1 is 45 degrees from s = 0. Beyond 1 the lines go on.
//(direction
vec3 direction(mat3 face, vec2 st) {
    //[solution
    vec2 on_cube = tan(radians(45.0) * st);
    return normalize(face * vec3(on_cube, 1.0));
    //]starter
    //| return unfinished(normalize(face * vec3(0.6, 0.3, 1.0)));
    //]
}
//)

// TASK 9.2 (4 points): the gradient of the heights, as a vector in space that is tangent to the unit sphere. u and v are
// the derivatives of the direction by s and by t: tangents of the grid, in general neither of unit length nor
// perpendicular. The heights grow by slope.x per unit of s and by slope.y per unit of t. So you look for the vector g in
// the plane of u and v with dot(g, u) = slope.x and dot(g, v) = slope.y.
//(gradient
vec3 gradient(vec3 u, vec3 v, vec2 slope) {
    //[solution
    float e = dot(u, u);
    float f = dot(u, v);
    float g = dot(v, v);
    return ((g * slope.x - f * slope.y) * u + (e * slope.y - f * slope.x) * v) / (e * g - f * f);
    //]starter
    //| return unfinished(vec3(0.0));
    //]
}
//)

// TASK 9.3 (2 points): the planet's normal, of unit length. The ground lies at (1 + height) r, in radii of the planet; r
// has unit length, and `grad` is the gradient of 9.2, of the heights in radii.
//(normal
vec3 planet_normal(vec3 r, float height, vec3 grad) {
    //[solution
    return normalize((1.0 + height) * r - grad);
    //]starter
    //| return unfinished(r);
    //]
}
//)

// TASK 9.4 (2 points): the place (s, t) on its face of a texel of a patch's map. Level 0 has one patch a face, each level
// cuts a patch in two by two: at level l the patch (x, y) is one of 2^l x 2^l, counted from the corner (-1, -1). The
// patch is `texels` texels wide, and the texels 1 to `texels` lie on it, each at the middle of its share; so the middle
// of texel 1 is half a texel from the patch's edge. Texel 0 and texel texels + 1 are the gutter: they lie beyond the
// edge, and their places, too.
//(gutter
vec2 gutter_place(ivec2 texel, ivec2 patch_, int level, int texels) {
    //[solution
    vec2 share = (vec2(texel) - 0.5) / float(texels);
    return 2.0 * (vec2(patch_) + share) / exp2(float(level)) - 1.0;
    //]starter
    //| return unfinished(vec2(0.0));
    //]
}
//)

// TASK 9.5 (3 points): the slopes of the heights by Sobel's filter, per unit of s and of t. h holds a texel and its
// eight neighbours, row by row from below, each row from left to right: h[4] is the texel itself, h[5] lies to its right
// and h[7] above it. A patch of level l is `texels` texels wide and covers 2^-l of its face, whose s and t run from -1
// to 1.
//(slopes
vec2 slopes(float h[9], int texels, int level) {
    //[solution
    float along_s = h[2] - h[0] + 2.0 * (h[5] - h[3]) + h[8] - h[6];
    float along_t = h[6] - h[0] + 2.0 * (h[7] - h[1]) + h[8] - h[2];
    return vec2(along_s, along_t) / 8.0 * (0.5 * float(texels) * exp2(float(level)));
    //]starter
    //| return unfinished(vec2(0.0));
    //]
}
//)
