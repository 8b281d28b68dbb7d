// A lawn from above.
#pragma once

#include "framework/core/image/image.h"

namespace relief {

constexpr int grass_texels = 512;

/// A height of the lawn's map is worth so many texels.
constexpr double grass_depth_in_texels = 5;

/// Both tile. `albedo`: diffuse colour, 3 channels, sRGB, 8 bits. `heights`: the upper blade's, 1 channel, in [0, 1],
/// of half as many texels a side.
struct GrassMaps {
    Image albedo, heights;
};
GrassMaps make_grass();

}  // namespace relief
