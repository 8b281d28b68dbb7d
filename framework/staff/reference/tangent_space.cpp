#include "framework/staff/reference/tangent_space.h"

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

glm::dvec3 to_interpolated_frame(const glm::dvec3& direction, const glm::dvec3& normal, const glm::dvec4& tangent) {
    return glm::normalize(glm::inverse(interpolated_frame(normal, tangent)) * direction);
}

}  // namespace relief
