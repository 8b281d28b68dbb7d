// The exact values of lab 10's probes.
#pragma once

#include <functional>

#include "framework/core/base/from_staff.h"
#include "framework/library/kit/relief_surface.h"

namespace relief::offsets {

/// Returns the function that computes the exact values at the first hits of the view rays of a frame, independent of
/// the method. +infinity beside the surface. The surface's mesh must outlive the function. Empty for a probe that
/// depends on the method only.
inline FromStaff<std::function<Image(const Frame&)>(const Probe& probe, const ReliefSurface& surface)> truth;

}  // namespace relief::offsets
