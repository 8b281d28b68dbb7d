// A surface pressed in by a height map: p' = p + scale (h - 1) n, and its normal. Twins of the
// functions in shaders/13_displacement/task.glsl.
#pragma once

#include "framework/staff/reference/surfaces.h"

namespace relief {

/// A height and its slope dh/du, dh/dv in the u and v of the SurfacePoint that it belongs to.
struct HeightPoint {
    double height;
    glm::dvec2 slope;
};

struct DisplacedPoint {
    glm::dvec3 position;
    glm::dvec3 normal;  ///< unit; the base's own where the displaced surface has none (a crease, a point)
};

/// Height 1 stays on the base and 0 lies `scale` metres inside. The normal is that of the displaced surface, with the
/// turning of the base's own normal: without it slopes are wrong by 1 + scale (h - 1) / radius (Blinn 1978 left it
/// out).
DisplacedPoint displace(const SurfacePoint& base, const HeightPoint& height, double scale);

}  // namespace relief
