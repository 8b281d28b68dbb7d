// A direction perpendicular to another.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace relief {

/// Returns a unit vector perpendicular to a unit vector. Branch-free, and exact for every direction (Duff et al. 2017).
/// Discontinuous where z changes its sign; no such function is continuous everywhere.
inline glm::dvec3 any_perpendicular(const glm::dvec3& unit) {
    const double sign = std::copysign(1.0, unit.z), a = -1 / (sign + unit.z);
    return {1 + sign * unit.x * unit.x * a, sign * unit.x * unit.y * a, -sign * unit.x};
}

}  // namespace relief
