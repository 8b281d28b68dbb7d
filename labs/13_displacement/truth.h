// The exact values of lab 13's probes.
#pragma once

#include <optional>

#include "framework/base/from_staff.h"
#include "framework/kit/displaced_surface.h"

namespace relief::displacement {

/// `depth`, `slope` and `normal` of the displaced wall, where each view ray meets the bilinear surface first, from
/// either side; `winding` of closed surfaces. Empty for other probes.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const DisplacedSurface& surface)> truth;

}  // namespace relief::displacement
