// The exact values of lab 10's probes.
#pragma once

#include <vector>

#include "framework/lab/relief_surface.h"

namespace relief::offsets {

/// Where the view rays of each frame meet the relief, whatever the method guesses; +infinity beside the surface. Empty
/// in a student's course, and for a probe that depends on the method alone.
std::vector<Image> truths(const std::vector<Frame>& frames, const Probe& probe, const ReliefSurface& surface);

}  // namespace relief::offsets
