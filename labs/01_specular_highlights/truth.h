// The exact values of lab 01's probes.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"

namespace relief::colonnade {

/// Returns the exact values of the probe `direction`, `normal` or `uv` at every pixel of a view; +infinity where there
/// is no surface. Columns, balls and floor are exact shapes. Their reliefs are the height maps from which the normal
/// maps were made, with central differences at texels, interpolated between them. Nothing is averaged over a pixel's
/// footprint, so far away a picture cannot have these normals. `strength` multiplies the slopes.
inline FromStaff<std::optional<Image>(const Frame& view, double strength)> truth;

}  // namespace relief::colonnade
