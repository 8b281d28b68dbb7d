// The exact values of lab 13's probes.
#pragma once

#include <optional>

#include "framework/core/base/from_staff.h"
#include "framework/core/kit/displaced_surface.h"

namespace relief::displacement {

/// Returns the exact values of a probe. `depth`, `slope` and `normal` are for the displaced wall, at the first hit of
/// each view ray with either side of the bilinear surface. `winding` is for closed surfaces. Returns nothing for other
/// probes.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const DisplacedSurface& surface)> truth;

}  // namespace relief::displacement
