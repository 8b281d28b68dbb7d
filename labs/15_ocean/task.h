// The function that task.cpp of lab 15 defines.
#pragma once

#include <glm/glm.hpp>

namespace relief::ocean {

/// Returns how far a map has moved after `time` seconds, in tiles modulo 1: in [0, 1). `velocity` is in tiles per
/// second. The time may be negative, or years.
glm::dvec2 scroll(const glm::dvec2& velocity, double time);

}  // namespace relief::ocean
