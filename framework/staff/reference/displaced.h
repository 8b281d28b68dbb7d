// A displaced surface, p' = p + scale (h - 1) n, and its normal. Twins of the functions in
// shaders/13_displacement/task.glsl.
#pragma once

#include "framework/staff/reference/surfaces.h"

namespace relief {

/// A height in [0, 1] and its slope (dh/du, dh/dv), in the u and v of the SurfacePoint.
struct HeightPoint {
    double height;
    glm::dvec2 slope;
};

struct DisplacedPoint {
    glm::dvec3 position;
    glm::dvec3 normal;  ///< unit length; the base's normal where the displaced surface has none (a crease, a point)
};

/// Returns the displaced point. Height 1 stays on the base; height 0 lies `scale` metres inside. The normal includes
/// the curvature of the base. Blinn (1978) omits it: slopes are then wrong by the factor 1 + scale (h - 1) / radius.
DisplacedPoint displace(const SurfacePoint& base, const HeightPoint& height, double scale);

}  // namespace relief
