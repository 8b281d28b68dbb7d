// The exact values of lab 14's probes.
#pragma once

#include <optional>

#include "framework/core/base/from_staff.h"
#include "framework/library/kit/displaced_surface.h"
#include "settings.h"

namespace relief::adaptive {

/// Returns the exact values of a probe on the ground, as means of 16 x 16 view rays of each pixel, each up to its first
/// hit with all of the displacement:
///  - `normal`: the unit normal of the mean slope that the rays hit
///  - `highlight`: the mean share of the light
/// Returns nothing for other probes and surfaces.
inline FromStaff<std::optional<Image>(const Frame& frame, const Settings& settings, const DisplacedSurface& surface)>
    truth;

}  // namespace relief::adaptive
