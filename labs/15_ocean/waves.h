// The waves of lab 15's two maps.
#pragma once

#include "wave_maps.h"

namespace relief::ocean {

/// Width of a map that is tiled once, metres.
constexpr double tile_metres = 16;
constexpr int map_texels = 256, waves_a_map = 24;

/// Returns the waves of a map. Map 0 has long waves along the wind, map 1 short ones in all directions. uv.y grows
/// along z.
const std::vector<PlaneWave>& waves_of(int map);

/// Return the moments of map 0 or 1, and its images, for a map that is tiled once.
inline glm::dvec3 slope_moments(int map) { return slope_moments(waves_of(map), tile_metres); }
inline WaveMaps make_maps(int map) { return wave_maps(waves_of(map), map_texels, tile_metres); }

}  // namespace relief::ocean
