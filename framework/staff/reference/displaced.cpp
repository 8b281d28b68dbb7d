#include "framework/staff/reference/displaced.h"

#include <cmath>

namespace relief {

DisplacedPoint displace(const SurfacePoint& base, const HeightPoint& height, double scale) {
    const double depth = scale * (height.height - 1);
    const glm::dvec3 du = base.du + depth * base.normal_du + scale * height.slope.x * base.normal;
    const glm::dvec3 dv = base.dv + depth * base.normal_dv + scale * height.slope.y * base.normal;
    const glm::dvec3 across = glm::cross(du, dv);
    const double length = glm::length(across);
    // Beyond the base's centre of curvature the surface is inside out. The normal stays on the base's outside.
    const double side = glm::dot(across, base.normal) < 0 ? -1 : 1;
    return {base.position + depth * base.normal,
            length > 0 && std::isfinite(length) ? side * across / length : base.normal};
}

}  // namespace relief
