// Height maps for testing searches, made from formulas: each is hard in its own way.
#pragma once

#include <array>
#include <string>

#include "framework/core/image/image.h"

namespace relief {

/// All of them tile. Each but the flat ones has 0 as its minimum and 1 as its maximum; `damaged` goes beyond.
enum class HeightMap {
    smooth,   ///< waves of an eighth of the tile and longer
    fbm,      ///< waves down to 4 texels, with the spectrum of all such waves at amplitudes frequency^-2
    bricks,   ///< flat tops, bevels two texels wide, deep joints
    stones,   ///< rounded cobbles of many heights
    posts,    ///< one texel wide, every sixteen texels: a step that is too long misses them
    rock,     ///< as from a photograph: ledges, cracks, and grain of one texel
    low,      ///< 0 everywhere
    high,     ///< 1 everywhere
    plateau,  ///< 0.5 everywhere
    damaged   ///< stones with texels that are NaN, infinite, or beyond [0, 1]
};
inline constexpr std::array height_map_names = {"smooth", "fbm", "bricks", "stones",  "posts",
                                                "rock",   "low", "high",   "plateau", "damaged"};

/// Returns a height map of one channel and `size` x `size` floats, `size` at least 1. The features of all but `fbm`,
/// `posts` and `rock` scale with the map.
Image make_height_map(HeightMap map, int size);

/// Makes a map safe for searches: clamps heights to [0, 1] and replaces NaN by 0.
void mend_heights(Image& heights);

/// Returns the map with heights rounded to multiples of 1/255 and `bits` 8.
Image with_8_bits(Image heights);

}  // namespace relief
