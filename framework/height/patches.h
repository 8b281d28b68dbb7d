// A height map's bounds on each patch of a tessellated surface: its heights, its steepness, and the error of each
// level. For choosing levels and culling before any vertex is made.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "framework/image/image.h"

namespace relief {

/// A patch's corner, as far as the height map is concerned. Its inside reads heights at `uv`; where two patches meet
/// both read the same ones. uv are in tiles.
struct HeightCorner {
    glm::vec3 position;   ///< metres
    glm::vec2 uv;         ///< (bi)linear between the corners
    glm::vec2 height_uv;  ///< where the corner itself reads
    glm::vec4 edge_uv;    ///< where the edge to the next corner reads: here (xy) and there (zw), linear between
};

/// Levels 1, 2, 4, ..., 64.
constexpr int level_octaves = 7;
/// By how much chords are off at each of those levels, or at any level above it: never rising. In heights. It is three
/// times the root mean square, or half of the most where that is more: 99 of 100 places are within it, and none is off
/// by more than twice as much. (With the most itself a rough relief takes 1.4 times the triangles for the same error of
/// 99 of 100 pixels: patches differ in how rare their worst place is.)
using LevelErrors = std::array<float, level_octaves>;

struct PatchHeights {
    /// The least and the most that a filter can read on the patch, its edges and corners, in any mip level; 1/255
    /// apart from what is there, so that a map and a filter of 8 bits may round.
    float lowest, highest;
    /// The most that the height at `uv` changes per metre of the flat patch, between any two of its places, in any mip
    /// level. Never more than 1e6, which is also what a patch has whose positions collapse and whose heights do not.
    float slope;
    LevelErrors inside;                 ///< of the patch cut evenly; of a quad's cells, with the worse of the diagonals
    std::array<float, 4> edge_heights;  ///< in the middle between the lowest and the highest of each edge
    std::array<LevelErrors, 4> edges;   ///< of edge i, from corner i to the next; 3 of a triangle
};

/// Each `corners` points are a patch, counter-clockwise: 3, or 4 whose places are (0, 0), (1, 0), (1, 1), (0, 1) of the
/// domain. `heights` has one channel and repeats; its surface is the bilinear one through the texel centres. Errors are
/// those of mip level 0. They are looked for at two places a texel (eight on edges), at least 16 along a side (64) and
/// no more than 128 (512), so a relief with sharp features can hide some between. A level whose vertices are as dense
/// as that is taken to be off by half as much as the one before, or more. Heights should be finite; what is not a
/// number does not count. Most of the time goes into errors: without `with_errors` they are 0.
std::vector<PatchHeights> measure_patches(std::span<const HeightCorner> points, int corners, const Image& heights,
                                          bool with_errors = true);

}  // namespace relief
