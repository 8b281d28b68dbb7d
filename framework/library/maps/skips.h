// Maps that are computed from a height map before any ray is cast. With them, a search skips space that holds no hit.
//
// Heights are the bilinear surface through the texel centres of a map that repeats. Cell (x, y) has its lower left
// corner at the centre of texel (x, y), where row 0 is the lowest; its maximum is at a corner. Images have row 0 at the
// top, as everywhere.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "framework/core/image/image.h"

namespace relief {

/// Clearances above the map, for rays that skip many cells at once. A ray only looks ahead, so each block of cells has
/// its windows for eight octants of directions: 0 for rays along +u and +v, 1 for -u, 2 for -v, 3 for both, and 4 more
/// where a ray passes more cells along v than along u. Window k of an octant is the block and `extent[octant / 4][k]`
/// more cells ahead, along u and along v. The stored clearance is 1 - (the maximum height in the window), in 1/255,
/// rounded down. A ray that enters at height 1 and falls by 1 per unit of t stays above the whole window until t equals
/// the clearance.
struct HeightWindows {
    int block = 1;                                      ///< cells along a block's side, a power of two
    std::array<std::array<glm::ivec2, 4>, 2> extent{};  ///< cells; whole blocks
    Image clearance;  ///< a texel per block, an 8-bit channel per window; octants stacked, 0 lowest

    /// Returns `extent` for exact_hit() in shaders/common/exact_hit.glsl: a row per window; a column for u and one for
    /// v, of the octants 0 to 3, then of 4 to 7.
    glm::mat4 extents() const;
};

/// Returns the windows for which rays of all slants take the fewest iterations on this map. Blocks are 1 cell where a
/// side is below 512 cells, else 2 x 2. Larger maps have larger blocks, so that the shorter side has at most 512
/// blocks. Throws Error when a side is not a power of two or the map has more than one channel.
HeightWindows height_windows(const Image& heights);

/// Returns the maximum height in the 5 x 5 cells around each cell. Throws Error as height_windows() does.
Image highest_in_5x5(const Image& heights);

/// Returns for each cell the widest empty cone that stands on it (Dummer 2006), in texels of radius per unit of height.
/// The cone's foot is the whole cell at the height of its highest corner; no other cell within `cone_reach` rises into
/// the cone. So it is conservative for the bilinear surface, not only at texel centres. Its radius at height 1 is at
/// most `cone_reach`, and it is clamped to `cone_widest` texels per unit. Throws Error as height_windows() does.
Image cone_map(const Image& heights, unsigned threads = 0);
constexpr int cone_reach = 32;
constexpr float cone_widest = 4096;

}  // namespace relief
