// The exact values of lab 10's probes.
#pragma once

#include <vector>

#include "framework/core/base/from_staff.h"
#include "framework/core/kit/relief_surface.h"

namespace relief::offsets {

/// Returns the exact values at the first hits of the view rays, one image per frame, independent of the method.
/// +infinity beside the surface. Empty for a probe that depends on the method only.
inline FromStaff<std::vector<Image>(const std::vector<Frame>& frames, const Probe& probe, const ReliefSurface& surface)>
    truths;

}  // namespace relief::offsets
