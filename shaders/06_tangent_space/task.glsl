// Lab 06, your tasks: a frame at every pixel, and its use.

#include "common/perpendicular.glsl"
#include "common/unfinished.glsl"

// TASK 6.1 (4 points): the frame of a pixel: the columns are tangent, bitangent and normal, of unit length and at
// right angles. `normal` has unit length already. `tangent` is interpolated between vertices: it is not of unit
// length, and no longer quite perpendicular. Keep the normal, subtract from the tangent its part along the normal
// (Gram-Schmidt), and use the handedness in w. A tangent parallel to the normal (after the subtraction almost nothing
// is left, compared with its length), or of length 0, must not give NaN: use any perpendicular.
//(frame
mat3 tangent_frame(vec3 normal, vec4 tangent) {
    //[solution
    vec3 across = tangent.xyz - dot(tangent.xyz, normal) * normal;
    float squared = dot(across, across);
    vec3 t = squared > 1e-10 * dot(tangent.xyz, tangent.xyz) ? across * inversesqrt(squared) : any_perpendicular(normal);
    return mat3(t, tangent.w * cross(normal, t), normal);
    //]starter
    //| return unfinished(mat3(1.0));
    //]
}
//)

// TASK 6.2 (2 points): transform a world-space direction into the frame of 6.1. If the columns of a matrix are
// orthonormal, its transpose is its inverse.
vec3 to_tangent_space(vec3 direction, mat3 frame) {
    //[solution
    return transpose(frame) * direction;
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}

// TASK 6.3 (4 points): transform a normal of the model to the world. Any length will do, but it must be on the right
// side. If the model is scaled by different numbers along its axes, normals need the inverse transpose of m. The
// columns of the inverse transpose, times the determinant of m, are cross(m[1], m[2]), cross(m[2], m[0]) and
// cross(m[0], m[1]): they are finite even where a scale is 0. Multiply by the determinant's sign (0 counts as positive;
// GLSL's sign(0.0) is 0).
//(normal
vec3 world_normal(vec3 normal, mat3 m) {
    //[solution
    mat3 cofactors = mat3(cross(m[1], m[2]), cross(m[2], m[0]), cross(m[0], m[1]));
    return (determinant(m) < 0.0 ? -1.0 : 1.0) * (cofactors * normal);
    //]starter
    //| return unfinished(normal);
    //]
}
//)

// TASK 6.4 (3 points): rotate the texture by `angle` (radians). The point of the surface that read the texture at uv
// now reads it at R (uv - 1/2) + 1/2, where R maps (1, 0) to (cos, sin): at (1, 1/2) that is (1/2 + cos/2, 1/2 +
// sin/2). Then rotate the tangent: in which direction of the surface does the rotated u grow? Not along R: if you
// rotate the coordinates one way, the picture turns the other way.
vec2 turned_uv(vec2 uv, float angle) {
    //[solution
    float c = cos(angle), s = sin(angle);
    return mat2(c, s, -s, c) * (uv - 0.5) + 0.5;
    //]starter
    //| return unfinished(uv);
    //]
}

vec3 turned_tangent(vec3 tangent, vec3 bitangent, float angle) {
    //[solution
    return cos(angle) * tangent - sin(angle) * bitangent;
    //]starter
    //| return unfinished(tangent);
    //]
}

// TASK 6.5 (2 points): transform a tangent of the model to the world. Any length will do: 6.1 normalises it. m maps
// points of the model to the world. A tangent is the difference of two near points of the surface: which matrix maps
// it? Not that of 6.3, which keeps normals perpendicular to the surface.
//(tangent
vec3 world_tangent(vec3 tangent, mat3 m) {
    //[solution
    return m * tangent;
    //]starter
    //| return unfinished(tangent);
    //]
}
//)
