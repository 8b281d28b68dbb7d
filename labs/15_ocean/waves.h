// The two wave maps of lab 15: sums of cosines, as formulas and as images.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "framework/image/image.h"

namespace relief::ocean {

/// Width of a map that is tiled once, metres.
constexpr double tile_metres = 16;
constexpr int map_texels = 256, waves_a_map = 24;

/// amplitude * cos(2 pi dot(k, uv) + phase): whole wave numbers, so that the map tiles.
struct Wave {
    glm::ivec2 k;
    double amplitude, phase;  ///< metres; radians
};

/// Map 0 has long waves along the wind, map 1 short ones in all directions. Their significant wave height, four times
/// the root mean square, is one metre; uv.y grows along z.
const std::array<Wave, waves_a_map>& waves_of(int map);

/// Mean of the squared slope along x, along z, and of the product of both, of a map that is tiled once.
glm::dvec3 slope_moments(int map);

/// What the maps hold at the middle of each texel, row 0 at the top (uv.y = 1), tiled once.
struct MapImages {
    Image waves;    ///< slopes along x and z, height in metres; floats
    Image moments;  ///< squared slope along x, along z, and their product; floats
    Image normals;  ///< unit normal with z upwards, (n + 1) / 2 in 8 bits
};
MapImages make_maps(int map);

}  // namespace relief::ocean
