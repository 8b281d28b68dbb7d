// The exact values of lab 17's probes.
#pragma once

#include "framework/core/base/from_staff.h"

#include <optional>

#include "wall.h"

namespace relief::budget {

/// Returns the exact values of the probes `uv`, `pixels`, `left`, `level` and `bumps`. Returns nothing for others.
inline FromStaff<std::optional<Image>(const FrameBudget& budget, const MapErrors& maps, const Image& heights)> truth;

}  // namespace relief::budget
