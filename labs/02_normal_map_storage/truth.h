// The exact values of lab 02's probes.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"

namespace relief::storage {

/// Of `normal`, the direction before it was stored; of `stored`, the codes that double precision gives. +infinity
/// beside the sphere, and below it where the format keeps no z.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, int format)> truth;

}  // namespace relief::storage
