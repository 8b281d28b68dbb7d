// Lab 06, yours: a frame at every pixel, and what is done in it.

#include "common/perpendicular.glsl"
#include "common/unfinished.glsl"

// TASK 6.1 (4 points): the frame of a pixel: columns tangent, bitangent, normal, unit and at right angles. `normal` is unit;
// `tangent` is interpolated between vertices: not unit, and no longer quite perpendicular. Keep the normal, take out of the
// tangent what lies along it (Gram-Schmidt), and mind the handedness in w. A tangent that lies along the normal (little
// is left of it, beside its length), or none, must not give NaN: any perpendicular will do.
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

// TASK 6.2 (2 points): a direction of the world in the frame of 6.1. A matrix of perpendicular unit columns is undone by its
// transpose.
vec3 to_tangent_space(vec3 direction, mat3 frame) {
    //[solution
    return transpose(frame) * direction;
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}

// TASK 6.3 (4 points): a normal of the model in the world, of any length but the right side. Where the model is scaled more
// along one axis than along another, a normal does not go along: it takes the inverse transpose. cross(m[1], m[2]),
// cross(m[2], m[0]) and cross(m[0], m[1]) are the columns of that, times the determinant, whose sign you must undo (0 counts
// as positive; GLSL's sign(0.0) is 0); and they are finite where a scale is 0.
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

// TASK 6.4 (3 points): the texture turned by `angle` (radians): the place of the surface that read the texture at uv reads it
// at R (uv - 1/2) + 1/2, where R takes (1, 0) to (cos, sin): at (1, 1/2) that is (1/2 + cos/2, 1/2 + sin/2). And the
// tangent that goes with it: along which direction of the surface does the turned u grow? Not along R: if you turn the
// coordinates one way, the picture turns the other.
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
