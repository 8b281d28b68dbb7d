// The exact values of lab 10's probes.
#pragma once

#include <vector>

#include "framework/base/from_staff.h"
#include "framework/kit/relief_surface.h"

namespace relief::offsets {

/// Where the view rays of each frame meet the relief, whatever the method guesses; +infinity beside the surface. Empty
/// for a probe that depends on the method alone.
inline FromStaff<std::vector<Image>(const std::vector<Frame>& frames, const Probe& probe, const ReliefSurface& surface)>
    truths;

}  // namespace relief::offsets
