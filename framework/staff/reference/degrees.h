// The angle between two directions, as errors of normals and tangents are measured.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace relief {

/// Returns the angle between `a` and `b`, of any length, in degrees. Exact to rounding also for small angles.
inline double degrees_between(const glm::dvec3& a, const glm::dvec3& b) {
    return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

}  // namespace relief
