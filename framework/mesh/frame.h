// A direction across a normal, where any will do.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

namespace relief {

/// A unit vector perpendicular to `normal`, which must be unit. Without branches and without a normal for which it
/// fails; it jumps where normal.z changes its sign (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
inline glm::dvec3 any_perpendicular(const glm::dvec3& normal) {
    const double sign = std::copysign(1.0, normal.z), a = -1 / (sign + normal.z);
    return {1 + sign * normal.x * normal.x * a, sign * normal.x * normal.y * a, -sign * normal.x};
}

}  // namespace relief
