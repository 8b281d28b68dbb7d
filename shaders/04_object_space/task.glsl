// Lab 04, your tasks: normals that move with their model.

#include "common/unfinished.glsl"

// TASK 4.1 (2 points): transform a normal from object space to world space, of unit length. The model may be rotated
// and moved, and scaled by one number, but not sheared: the normal rotates with the model, and its position does not
// matter.
vec3 world_from_object(vec3 normal, mat4 world_from_model) {
    //[solution
    return normalize(mat3(world_from_model) * normal);
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}

// TASK 4.2 (4 points): the twist rotates a point at height y about the y axis by a = rate * y radians:
//     x' = x cos a + z sin a,   y' = y,   z' = -x sin a + z cos a.
// Write its Jacobian: the columns are d(x', y', z')/dx, d/dy and d/dz. (a depends on y: mind the second column.)
//(jacobian
mat3 twist_jacobian(vec3 position, float rate) {
    //[solution
    float c = cos(rate * position.y), s = sin(rate * position.y);
    vec3 along_y = vec3(rate * (position.z * c - position.x * s), 1.0, -rate * (position.x * c + position.z * s));
    return mat3(vec3(c, 0.0, -s), along_y, vec3(s, 0.0, c));
    //]starter
    //| return unfinished(mat3(1.0));
    //]
}
//)

// TASK 4.3 (4 points): transform a normal from tangent space to the deformed surface, of unit length. `tangent` and
// `bitangent` are already transformed: before, they were of unit length and at right angles; now they may be neither.
// n = cross(tangent, bitangent), normalised, is the normal of the deformed surface. A slope along the tangent tilts
// the normal at a right angle to the bitangent. So the axes for x and y are cross(bitangent, n) and cross(n, tangent);
// the axis for z is cross(tangent, bitangent), not normalised.
//(carried
vec3 object_from_tangent(vec3 normal, vec3 tangent, vec3 bitangent) {
    //[solution
    vec3 up = cross(tangent, bitangent), n = normalize(up);
    return normalize(normal.x * cross(bitangent, n) + normal.y * cross(n, tangent) + normal.z * up);
    //]starter
    //| return unfinished(vec3(0.0, 0.0, 1.0));
    //]
}
//)
