// Lab 19, your tasks: a layer of detail on a normal map, three planes of maps around a solid, and the highlight of normals
// that a pixel has averaged. Normals have unit length, z points out of the surface. A slope is (dh/du, dh/dv).

#include "common/unfinished.glsl"

// TASK 19.1 (2 points): the normal of a layer whose heights are multiplied by `strength`, which is not negative. Heights
// and slopes grow by the same factor. normal.z is above 0. With a strength of 1 the normal stays as it is.
//(scaled
vec3 scaled(vec3 normal, float strength) {
    //[solution
    return normalize(vec3(strength * normal.xy, normal.z));
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}
//)

// TASK 19.2 (2 points): the normal of a surface whose height is the sum of two heights. The arguments are the normals of
// both; their z is above 0. (Do not divide: steep normals have a z near 0.)
//(sum
vec3 sum_of_heights(vec3 base, vec3 detail) {
    //[solution
    return normalize(vec3(base.xy * detail.z + detail.xy * base.z, base.z * detail.z));
    //]starter
    //| return unfinished(base);
    //]
}
//)

// TASK 19.3 (2 points): the detail, rotated with the base: by the shortest rotation that takes (0, 0, 1) to `base`, whose
// z is not negative. This rotation is the product of two reflections: first in the plane perpendicular to (0, 0, 1), then in
// the one perpendicular to base + (0, 0, 1).
//(rotated
vec3 rotated_onto(vec3 base, vec3 detail) {
    //[solution
    vec3 across = base + vec3(0.0, 0.0, 1.0), mirrored = detail * vec3(1.0, 1.0, -1.0);
    return mirrored - across * (2.0 * dot(across, mirrored) / dot(across, across));
    //]starter
    //| return unfinished(base);
    //]
}
//)

// TASK 19.4 (2 points): the weights of the three planes, perpendicular to x, y and z: the powers |n.x|^sharpness and so
// on, divided by their sum. The sharpness is from 1 to 64. (GLSL's pow() takes no negative base.)
//(weights
vec3 plane_weights(vec3 normal, float sharpness) {
    //[solution
    vec3 size = pow(abs(normal), vec3(sharpness));
    return size / (size.x + size.y + size.z);
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}
//)

// TASK 19.5 (3 points): plane_frame() has three columns: the directions along which u and v of a map grow in space, and the
// outward direction, of unit length. `axis` (0, 1, 2) is the axis that the plane is perpendicular to; `side` is 1 where the
// surface faces the axis's positive end, else -1. Seen from outside, u runs to the right and v up, so that no text is
// mirrored. Where the axis is x or z, up is +y. Where it is y, u runs along +x on both sides.
// gradient_in() is the gradient in space of a map's heights, which lies in the plane.
//(plane
mat3 plane_frame(int axis, float side) {
    //[solution
    if (axis == 0) return mat3(vec3(0.0, 0.0, -side), vec3(0.0, 1.0, 0.0), vec3(side, 0.0, 0.0));
    if (axis == 1) return mat3(vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, -side), vec3(0.0, side, 0.0));
    return mat3(vec3(side, 0.0, 0.0), vec3(0.0, 1.0, 0.0), vec3(0.0, 0.0, side));
    //]starter
    //| return unfinished(mat3(1.0));
    //]
}

vec3 gradient_in(mat3 frame, vec2 slope) {
    //[solution
    return frame[0] * slope.x + frame[1] * slope.y;
    //]starter
    //| return unfinished(vec3(0.0));
    //]
}
//)

// TASK 19.6 (3 points): relief_gradient() is the gradient of the height h = sum w_i h_i of three planes. Column i of
// `gradients` is the gradient of h_i, and column i of `weight_gradients` that of w_i: the weights change along the surface,
// too. bumped() is the normal of the surface after it is displaced by h along its normal, if h is small:
// normal - (the part of the gradient that is tangent to the surface), of unit length.
//(gradient
vec3 relief_gradient(vec3 weights, vec3 heights, mat3 gradients, mat3 weight_gradients) {
    //[solution
    return gradients * weights + weight_gradients * heights;
    //]starter
    //| return unfinished(vec3(0.0));
    //]
}

vec3 bumped(vec3 normal, vec3 gradient) {
    //[solution
    return normalize(normal - gradient + dot(gradient, normal) * normal);
    //]starter
    //| return unfinished(normal);
    //]
}
//)

// TASK 19.7 (2 points): the variance of the slopes within a pixel. lost_variance() has it for a layer whose unit normals
// have the mean `mean_normal`: (1 - l) / l, where l is the mean's length (Toksvig 2005). turning_variance() has it for a
// normal that changes by `across` to the next pixel, and by `up` to the one above: a quarter of the squared lengths of
// both, but at most 0.09 (Tokuyoshi and Kaplanyan 2019).
//(variance
float lost_variance(vec3 mean_normal) {
    //[solution
    float l = length(mean_normal);
    return (1.0 - l) / l;
    //]starter
    //| return unfinished(0.0);
    //]
}

float turning_variance(vec3 across, vec3 up) {
    //[solution
    return min(0.25 * (dot(across, across) + dot(up, up)), 0.09);
    //]starter
    //| return unfinished(0.0);
    //]
}
//)
