// The slopes of a normal map, and their squares, as maps. Where a mip level averages slopes, it averages their squares,
// too, and the two give the variance that the level has lost (LEAN mapping: Olano and Baker 2010).
#pragma once

#include <glm/glm.hpp>

#include "framework/core/image/image.h"

namespace relief {

/// Returns the square of a slope along u, the square along v, and the product of both.
inline glm::dvec3 squares_of(glm::dvec2 slope) { return {slope * slope, slope.x * slope.y}; }

/// Maps of floats. Each mip level holds the means over the texels of level 0.
struct SlopeMaps {
    Image slopes;   ///< along u and v
    Image squares;  ///< squares_of() the slopes
};

/// Returns the maps of a normal map with three channels, (n + 1) / 2, whose z points out of the surface. A z below 0.01
/// counts as 0.01.
SlopeMaps slope_maps(const Image& normals);

}  // namespace relief
