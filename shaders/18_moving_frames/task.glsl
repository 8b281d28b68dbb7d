// Lab 18, your tasks: frames that move with a skin. The vertex stage includes this file, too; VERTEX_STAGE is defined there.

#include "common/unfinished.glsl"

// TASK 18.1 (4 points): the Jacobian of a skin, that is the derivative of the posed place x by the place p at rest:
//     x = sum w_i M_i p / sum w_i
// gradients[i] is the gradient of the weight w_i at p: the weights change along the skin, and each has a derivative, too.
// M_i p is (bones[i] * vec4(p, 1)).xyz. The weights need not sum to 1: mind the quotient. (outerProduct(a, b) is the
// matrix a b^T; it takes v to a * dot(b, v).)
//(jacobian
mat3 skin_jacobian(vec3 p, vec4 weights, vec3 gradients[4], mat4 bones[4]) {
    //[solution
    vec3 moved[4], x = vec3(0.0);
    float sum = 0.0;
    for (int i = 0; i < 4; ++i) {
        moved[i] = (bones[i] * vec4(p, 1.0)).xyz;
        x += weights[i] * moved[i];
        sum += weights[i];
    }
    x /= sum;
    mat3 jacobian = mat3(0.0);
    for (int i = 0; i < 4; ++i)
        jacobian += weights[i] * mat3(bones[i]) + outerProduct(moved[i] - x, gradients[i]);
    return jacobian / sum;
    //]starter
    //| return unfinished(mat3(1.0));
    //]
}
//)

// TASK 18.2 (3 points): move a frame by the Jacobian of a motion: of a skin, of an instance, or of both. Each tangent
// moves by the Jacobian itself; the normal by its cofactors, cross(j[1], j[2]), cross(j[2], j[0]) and
// cross(j[0], j[1]), times the sign of the determinant (0 counts as positive). Any length will do, no division is
// needed, and a scale of 0 is no harm. The handedness in w changes where the determinant is negative.
//(frame
vec3 moved_normal(vec3 normal, mat3 j) {
    //[solution
    vec3 moved = mat3(cross(j[1], j[2]), cross(j[2], j[0]), cross(j[0], j[1])) * normal;
    return determinant(j) < 0.0 ? -moved : moved;
    //]starter
    //| return unfinished(normal);
    //]
}

vec4 moved_tangent(vec4 tangent, mat3 j) {
    //[solution
    return vec4(j * tangent.xyz, determinant(j) < 0.0 ? -tangent.w : tangent.w);
    //]starter
    //| return unfinished(tangent);
    //]
}
//)

// TASK 18.3 (3 points): blend four rigid motions. Each is a dual quaternion: column 0 is the real part, the rotation
// (x, y, z, w), and column 1 the dual part. -q is the same motion as q, so first give all of them the sign for which
// their real part and that of bones[0] have a dot product that is not negative. Then add them by their weights, and
// divide both parts by the length of the real one. (If that is 0, return bones[0].)
//(blend
mat2x4 blended_motion(vec4 weights, mat2x4 bones[4]) {
    //[solution
    mat2x4 sum = mat2x4(0.0);
    for (int i = 0; i < 4; ++i) {
        float side = dot(bones[i][0], bones[0][0]) < 0.0 ? -1.0 : 1.0;
        sum += side * weights[i] * bones[i];
    }
    float size = length(sum[0]);
    return size > 0.0 ? sum / size : bones[0];
    //]starter
    //| return unfinished(bones[0]);
    //]
}
//)

// TASK 18.4 (3 points): where a body reads its texture, and along which directions of its surface the texture's
// coordinates grow. Coordinates (u, v, 1) go through the matrix of the instance first, then through that of its
// material. The columns of `surface` are the derivatives of the place by the body's own u and v; return those by the
// texture's. Only directions are needed: multiply the inverse by its determinant's size, so that a texture without
// extent (determinant 0) is no harm.
//(texture
vec2 texture_place(vec2 uv, mat3 instance, mat3 material) {
    //[solution
    return (material * (instance * vec3(uv, 1.0))).xy;
    //]starter
    //| return unfinished(uv);
    //]
}

mat2x3 texture_directions(mat2x3 surface, mat3 instance, mat3 material) {
    //[solution
    mat2 m = mat2(material) * mat2(instance);
    float side = determinant(m) < 0.0 ? -1.0 : 1.0;
    return surface * (side * mat2(m[1][1], -m[0][1], -m[1][0], m[0][0]));
    //]starter
    //| return unfinished(surface);
    //]
}
//)

// TASK 18.5 (2 points): hand the index of an instance's material on from the vertex stage to the fragment stage. All
// three corners of a triangle have the same index, but what is interpolated is a sum of three rounded products, times a
// rounded depth: 2.9999998 becomes 2, and the material flickers. A variable that is `flat` is not interpolated.
// passed.glsl declares one of each kind: write and read the right one.
//(passed
#ifdef VERTEX_STAGE
void pass_material(int index) {
    //[solution
    v_index = index;
    //]starter
    //| unfinished(0);
    //]
}
#else
int passed_material() {
    //[solution
    return v_index;
    //]starter
    //| return unfinished(0);
    //]
}
#endif
//)
