// The exact values of lab 02's probes.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"

namespace relief::storage {

/// Returns the exact values of a probe: for `normal` the direction before it is stored; for `stored` its codes,
/// computed in double precision. +infinity beside the sphere, and on its lower half if the format does not store z.
inline FromStaff<std::optional<Image>(const Frame& frame, int format)> truth;

}  // namespace relief::storage
