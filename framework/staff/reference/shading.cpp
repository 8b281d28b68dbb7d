#include "framework/staff/reference/shading.h"

#include <algorithm>
#include <cmath>

namespace relief {

glm::dvec3 blinn_phong(const glm::dvec3& albedo, double specular, double shininess, const glm::dvec3& normal,
                       const glm::dvec3& to_light, const glm::dvec3& to_eye) {
    const double facing = std::max(glm::dot(normal, to_light), 0.0);
    const glm::dvec3 between = to_light + to_eye;
    const double length = glm::length(between);
    const double lobe = length > 0 ? std::pow(std::max(glm::dot(normal, between) / length, 0.0), shininess) : 0;
    return facing * (albedo + specular * (shininess + 8) / 8 * lobe);
}

}  // namespace relief
