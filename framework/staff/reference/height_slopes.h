// The slope of a height map at a texel, written directly from its definition: the reference for normals_from_heights.
#pragma once

#include <glm/glm.hpp>

#include "framework/staff/reference/normals.h"

namespace relief {

/// dh/du and dh/dv, per texel, of a one-channel image; v grows up. Slow: the spline costs its whole line for each
/// texel.
glm::dvec2 slope_at(const Image& heights, int x, int y, SlopeFilter filter, bool wrap);

/// The unit normal of it.
glm::dvec3 normal_at(const Image& heights, int x, int y, const NormalOptions& options);

}  // namespace relief
