// The exact values of lab 17's probes.
#pragma once

#include "framework/base/from_staff.h"

#include <optional>

#include "wall.h"

namespace relief::budget {

inline FromStaff<std::optional<Image>(const Probe& probe, const FrameBudget& budget, const MapErrors& maps,
                                      const Image& heights)>
    truth;

}  // namespace relief::budget
