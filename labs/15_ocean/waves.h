// The two wave maps of lab 15: sums of cosines, in closed form and as images.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "framework/core/image/image.h"

namespace relief::ocean {

/// Width of a map that is tiled once, metres.
constexpr double tile_metres = 16;
constexpr int map_texels = 256, waves_a_map = 24;

/// A wave amplitude * cos(2 pi dot(k, uv) + phase). Wave numbers are whole, so that the map tiles.
struct Wave {
    glm::ivec2 k;
    double amplitude, phase;  ///< metres; radians
};

/// Returns the waves of a map. Map 0 has long waves along the wind, map 1 short ones in all directions. The significant
/// wave height of each map, four times the root mean square, is one metre. uv.y grows along z.
const std::array<Wave, waves_a_map>& waves_of(int map);

/// Returns the means of the squared slopes along x and along z, and of their product, over a map that is tiled once.
glm::dvec3 slope_moments(int map);

/// The maps at the centres of texels, for one tile. Row 0 is at the top (uv.y = 1).
struct MapImages {
    Image waves;    ///< slopes along x and z, height in metres; floats
    Image moments;  ///< squared slope along x, along z, and their product; floats
    Image normals;  ///< unit normal with z upwards, (n + 1) / 2 in 8 bits
};
/// Returns the images of map 0 or 1.
MapImages make_maps(int map);

/// Returns the heights of a user's picture, for maps_of_heights(): grey, of map_texels a side. Throws Error, without a
/// place, if the picture has colours or is of one height.
Image own_heights(Image picture);
/// Returns the normals of a user's picture, of map_texels a side: a normal map with green up. Throws Error, without a
/// place, for a grey picture, or one whose colours do not point upwards.
Image own_normals(Image picture);

/// Returns the images of a map from heights that tile, of map_texels a side. They are shifted and scaled so that their
/// mean is 0 and the significant wave height is one metre. Slopes are central differences.
MapImages maps_of_heights(const Image& heights);

}  // namespace relief::ocean
