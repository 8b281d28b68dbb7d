// The exact values of lab 04's probe.
#pragma once

#include "framework/lab/lab.h"

namespace relief::quilt {

/// The normal of the high-resolution surface after it was twisted (radians a metre) and placed in the world. Nothing in
/// a student's course.
std::optional<Image> truth(const Frame& frame, double rate, const glm::dmat4& world_from_model);

}  // namespace relief::quilt
