// Lab 05, your task: a tangent where the vertices have none.

#include "common/perpendicular.glsl"
#include "common/unfinished.glsl"

// TASK 5.4 (4 points): from one pixel to the next on the right the position changes by `position_dx` and the uv by
// `uv_dx`; to the next one above by `position_dy` and `uv_dy`. That is a triangle: solve it for dP/du as in task 5.1,
// subtract the part along the normal (which has unit length), and normalise the result. Store 1 in w, or -1 where the
// texture is mirrored: where dP/dv is on the other side than cross(normal, tangent). Where the uv do not change, or
// change along one line only, the determinant is 0: return any_perpendicular(normal), and never NaN.
//(derivatives
vec4 tangent_of_derivatives(vec3 normal, vec3 position_dx, vec3 position_dy, vec2 uv_dx, vec2 uv_dy) {
    //[solution
    float determinant = uv_dx.x * uv_dy.y - uv_dy.x * uv_dx.y;
    float side = determinant < 0.0 ? -1.0 : 1.0;
    vec3 along_u = side * (position_dx * uv_dy.y - position_dy * uv_dx.y);
    vec3 along_v = side * (position_dy * uv_dx.x - position_dx * uv_dy.x);
    vec3 tangent = along_u - dot(along_u, normal) * normal;
    float squared = dot(tangent, tangent);
    if (determinant == 0.0 || squared == 0.0) return vec4(any_perpendicular(normal), 1.0);
    return vec4(tangent * inversesqrt(squared), dot(cross(normal, tangent), along_v) < 0.0 ? -1.0 : 1.0);
    //]starter
    //| return unfinished(vec4(1.0, 0.0, 0.0, 1.0));
    //]
}
//)
