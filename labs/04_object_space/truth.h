// The exact values of lab 04's probes.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"

namespace relief::quilt {

/// Returns the exact values of a probe. `normal`: of the high-resolution surface, twisted by `rate` (radians per metre)
/// and placed in the world. `moved`: the sum of the column's tangent and bitangent, moved by the twist, in object
/// space.
inline FromStaff<std::optional<Image>(const Frame& frame, double rate, const glm::dmat4& world_from_model)> truth;

}  // namespace relief::quilt
