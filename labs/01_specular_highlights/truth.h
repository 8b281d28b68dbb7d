// The exact values of lab 01's probes.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"

namespace relief::colonnade {

/// Of the probe `normal` or `uv` at every pixel of a view, +infinity where it sees nothing. The columns, balls and
/// floor are round and flat as their formulas say, and their reliefs are the height maps from which the normal maps
/// were made: the slope at a texel is the central difference, and it is interpolated between texels. Nothing is
/// averaged over a pixel's footprint: far away a picture cannot have these normals.
inline FromStaff<std::optional<Image>(const Frame& view, const Probe& probe, double strength)> truth;

}  // namespace relief::colonnade
