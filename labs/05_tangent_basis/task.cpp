// Lab 05, your tasks: solve a triangle for its tangent, weigh it at a vertex, and make a frame of the result.
#include "task.h"

#include <cmath>

#include "framework/core/base/unfinished.h"

namespace relief::basis {

// TASK 5.1 (4 points): along the edges e1 = p1 - p0 and e2 = p2 - p0 the uv change by (s1, t1) and (s2, t2), so
//     e1 = s1 T + t1 B,   e2 = s2 T + t2 B.
// Solve for T and B, and normalise both: the weights of 5.2 must count, not the lengths. The determinant has a sign.
// Where it is 0, return 0 everywhere, so that such a triangle does not count in a mean.
//(solve
FaceBasis solve(const Triangle& triangle) {
    //[solution
    const auto& [p, uv] = triangle;
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0];
    const glm::dvec2 st1 = uv[1] - uv[0], st2 = uv[2] - uv[0];
    const double determinant = st1.x * st2.y - st2.x * st1.y;
    if (determinant == 0) return {};
    const glm::dvec3 tangent = (e1 * st2.y - e2 * st1.y) / determinant;
    const glm::dvec3 bitangent = (e2 * st1.x - e1 * st2.x) / determinant;
    if (glm::length(tangent) == 0 || glm::length(bitangent) == 0) return {};
    return {glm::normalize(tangent), glm::normalize(bitangent), determinant > 0 ? 1.0 : -1.0};
    //]starter
    //| static_cast<void>(triangle);
    //| unfinished("5.1");
    //]
}
//)

// TASK 5.2 (3 points): uniform: 1. By area: the triangle's area. By angle: its angle at the corner, in radians, by the
// arc tangent of sine and cosine (an arc cosine is inexact for small angles).
double corner_weight(Weight weight, const Triangle& triangle, int corner) {
    //[solution
    const auto& p = triangle.position;
    const glm::dvec3 here = p[size_t(corner)];
    const glm::dvec3 next = p[size_t(corner + 1) % 3] - here, previous = p[size_t(corner + 2) % 3] - here;
    const double twice_the_area = glm::length(glm::cross(next, previous));
    if (weight == Weight::area) return twice_the_area / 2;
    if (weight == Weight::angle) return std::atan2(twice_the_area, glm::dot(next, previous));
    return 1;
    //]starter
    //| static_cast<void>(weight), static_cast<void>(triangle), static_cast<void>(corner);
    //| unfinished("5.2");
    //]
}

// TASK 5.3 (3 points): Gram-Schmidt: subtract from the sum its part along the normal, and normalise the rest. If the
// sum is parallel to the normal, or zero, nothing is left: still return a frame.
glm::dvec4 vertex_tangent(const glm::dvec3& sum, const glm::dvec3& normal, double handedness) {
    //[solution
    const glm::dvec3 across = sum - glm::dot(sum, normal) * normal;
    const double length = glm::length(across);
    const glm::dvec3 tangent = length > 1e-9 * glm::length(sum) ? across / length : any_perpendicular(normal);
    return {tangent, handedness < 0 ? -1.0 : 1.0};
    //]starter
    //| static_cast<void>(sum), static_cast<void>(normal), static_cast<void>(handedness);
    //| unfinished("5.3");
    //]
}

}  // namespace relief::basis
