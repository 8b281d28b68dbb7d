#include "framework/staff/reference/tangent_space.h"

#include <algorithm>
#include <cmath>

namespace relief {

glm::dmat3 tangent_frame(const glm::dvec3& normal, const glm::dvec4& tangent) {
    const glm::dvec3 n = glm::normalize(normal), along(tangent);
    const glm::dvec3 t = glm::normalize(along - glm::dot(along, n) * n);
    return {t, tangent.w * glm::cross(n, t), n};
}

glm::dvec3 from_tangent_space(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent) {
    return glm::normalize(tangent_frame(normal, tangent) * direction);
}

glm::dvec3 to_tangent_space(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent) {
    return glm::normalize(direction * tangent_frame(normal, tangent));
}

glm::dmat3 interpolated_frame(const glm::dvec3& normal, const glm::dvec4& tangent) {
    const glm::dvec3 along(tangent);
    return {along, tangent.w * glm::cross(normal, along), normal};
}

glm::dvec3 from_interpolated_frame(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent) {
    return glm::normalize(interpolated_frame(normal, tangent) * direction);
}

glm::dvec3 to_interpolated_frame(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent) {
    return glm::normalize(glm::inverse(interpolated_frame(normal, tangent)) * direction);
}

glm::dmat3 cotangent_frame(const glm::dvec3& normal, const glm::dvec3& position_dx, const glm::dvec3& position_dy,
                           const glm::dvec2& uv_dx, const glm::dvec2& uv_dy) {
    const glm::dvec3 across_x = glm::cross(position_dy, normal), across_y = glm::cross(normal, position_dx);
    // dot(position_dx, across_x) is the sign of the frame: the screen may run against the surface's orientation.
    const double side = glm::dot(position_dx, across_x) < 0 ? -1 : 1;
    const glm::dvec3 t = side * (across_x * uv_dx.x + across_y * uv_dy.x);
    const glm::dvec3 b = side * (across_x * uv_dx.y + across_y * uv_dy.y);
    const double longest = std::sqrt(std::max(glm::dot(t, t), glm::dot(b, b)));
    const double scale = longest > 0 ? 1 / longest : 0;
    return {t * scale, b * scale, normal};
}

}  // namespace relief
