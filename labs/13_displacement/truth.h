// The exact values of lab 13's probes.
#pragma once

#include <optional>

#include "framework/lab/displaced_surface.h"

namespace relief::displacement {

/// `depth`, `slope` and `normal` of the displaced wall, where each view ray meets the bilinear surface first, from
/// either side; `winding` of whatever is closed. Nothing else is known.
std::optional<Image> truth(const Frame& frame, const Probe& probe, const DisplacedSurface& surface);

}  // namespace relief::displacement
