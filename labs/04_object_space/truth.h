// The exact values of lab 04's probe.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"

namespace relief::quilt {

/// The normal of the high-resolution surface after it was twisted (radians a metre) and placed in the world.
inline FromStaff<std::optional<Image>(const Frame& frame, double rate, const glm::dmat4& world_from_model)> truth;

}  // namespace relief::quilt
