// Height maps for testing searches, made from formulas: each is hard in its own way.
#pragma once

#include <array>
#include <string>

#include "framework/image/image.h"

namespace relief {

/// All of them tile, and have 0 as their lowest height and 1 as their highest where they are not flat.
enum class HeightMap {
    smooth,   ///< waves of an eighth of the tile and longer
    fbm,      ///< waves down to 4 texels: the spectrum of all of them with amplitudes frequency^-2
    bricks,   ///< flat tops, bevels two texels wide, deep joints
    stones,   ///< rounded cobbles of many heights
    posts,    ///< one texel wide, every sixteen texels: a step that is too long misses them
    rock,     ///< as from a photograph: ledges, cracks, and grain of one texel
    low,      ///< 0 everywhere
    high,     ///< 1 everywhere
    plateau,  ///< 0.5 everywhere
    damaged   ///< stones with texels that are not numbers, or beyond 0 and 1
};
inline constexpr std::array height_map_names = {"smooth", "fbm", "bricks", "stones",  "posts",
                                                "rock",   "low", "high",   "plateau", "damaged"};

/// One channel of `size` x `size` floats, `size` at least 1. The features of all but `fbm`, `posts` and `rock` grow
/// with the map.
Image make_height_map(HeightMap map, int size);

/// Makes a map safe for searches: every height finite and in [0, 1]. NaN becomes 0.
void mend_heights(Image& heights);

/// Rounded to the nearest of 256.
Image with_8_bits(Image heights);

}  // namespace relief
