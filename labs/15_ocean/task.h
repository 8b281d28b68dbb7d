// The function that task.cpp of lab 15 defines.
#pragma once

#include <glm/glm.hpp>

namespace relief::ocean {

/// How far a map has moved after `time` seconds, in tiles, without the whole ones: from 0 to 1, 1 itself excluded.
/// `velocity` is in tiles a second. The time may be negative, or years.
glm::dvec2 scroll(const glm::dvec2& velocity, double time);

}  // namespace relief::ocean
