// The slope of a height map at a texel, directly from the definition: the reference for normals_from_heights().
#pragma once

#include <glm/glm.hpp>

#include "framework/staff/reference/normals.h"

namespace relief {

/// Returns (dh/du, dh/dv) per texel of a one-channel image; v grows up. Slow: solves a spline along the texel's whole
/// row and column.
glm::dvec2 slope_at(const Image& heights, int x, int y, SlopeFilter filter, bool wrap);

/// Returns the unit normal of that slope.
glm::dvec3 normal_at(const Image& heights, int x, int y, const NormalOptions& options);

}  // namespace relief
