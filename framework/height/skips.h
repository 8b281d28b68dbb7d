// Maps that are computed from a height map before any ray is cast, so that a search may skip what it cannot hit.
//
// Heights are the bilinear surface through the texel centres of a map that repeats. Cell (x, y) has its lower left
// corner at the centre of texel (x, y), row 0 lowest; its highest point is a corner. The images have row 0 at the top,
// as all do.
#pragma once

#include <array>

#include "framework/image/image.h"

namespace relief {

/// A ray only looks ahead, so each block of cells has its windows in four quadrants: 0 for rays along +u and
/// +v, 1 for -u, 2 for -v, 3 for both. Window k of a quadrant is the block and `extent[k]` cells more on the
/// two sides ahead. What is stored is 1 - (the highest height in it) in 1/255, rounded down: a ray that enters at
/// height 1 and falls by 1 is above everything in the window until t is that number.
struct HeightWindows {
    int block = 1;                ///< cells along a block's side, a power of two
    std::array<int, 4> extent{};  ///< cells, rising; whole blocks
    Image clearance;              ///< a texel a block, 4 channels of 8 bits; quadrant above quadrant, 0 lowest
};

/// Blocks of 2 x 2 cells, of one where the map is small, and of more where there would be over 512 x 512; the windows
/// with which rays of all slants take the fewest turns on this map. Throws Error when a side is not a power of two.
HeightWindows height_windows(const Image& heights);

/// The highest height in the 5 x 5 cells around each cell.
Image highest_in_5x5(const Image& heights);

/// For each cell, the widest cone that stands on it and is empty (Dummer 2006), as texels of radius per unit of height:
/// its foot is the cell itself at its highest corner, and no other cell within `cone_reach` rises into it. So it is
/// right for rays over the bilinear surface, not only at texel centres. At height 1 it is no wider than cone_reach, and
/// cone_widest texels per unit at most.
Image cone_map(const Image& heights, unsigned threads = 0);
constexpr int cone_reach = 32;
constexpr float cone_widest = 4096;

}  // namespace relief
