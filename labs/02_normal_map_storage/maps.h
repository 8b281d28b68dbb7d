// The normal maps that lab 02 compresses.
#pragma once

#include <array>

#include "framework/core/image/image.h"

namespace relief::storage {

enum class MapName { shapes, bricks, paving };
inline constexpr std::array map_names = {"shapes", "bricks", "paving"};

/// Texels along each side of a map.
constexpr int map_size = 64;

/// Returns a map of unit normals, three floats a texel. `shapes` is computed: domes with a flat border, waves, and
/// ridges that do not align with the blocks. The others are 64 x 64 texels of the course's textures, decoded from 8
/// bits.
Image normal_map(MapName name);

/// Returns the heights of the same texels in [0, 1], one float a texel: those of which normal_map() has the slopes.
Image height_map(MapName name);

}  // namespace relief::storage
