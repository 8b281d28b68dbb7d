// The exact values of lab 13's probes.
#pragma once

#include <optional>

#include "framework/core/base/from_staff.h"
#include "framework/library/kit/displaced_surface.h"

namespace relief::displacement {

/// Returns the exact values of a probe. `depth`, `slope`, `normal` and `shadow` are for the displaced wall, at the
/// first hit of each view ray with either side of the bilinear surface. `shadow` is 1 where a ray to the light hits
/// nothing. `winding` is for closed surfaces. Returns nothing for other probes.
inline FromStaff<std::optional<Image>(const Frame& frame, const DisplacedSurface& surface, const glm::dvec3& to_light)>
    truth;

}  // namespace relief::displacement
