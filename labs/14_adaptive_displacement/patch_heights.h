// Bounds of a height map on each patch of a tessellated surface: its heights, its steepness, and the error of each
// tessellation level. They serve to choose levels and to cull before any vertex is made.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// A corner of a patch in the height map, with uv in tiles. The inside of the patch reads heights at `uv`. Edges and
/// corners read at `edge_uv` and `height_uv`, which are the same for all patches that meet there.
struct HeightCorner {
    glm::vec3 position;   ///< metres
    glm::vec2 uv;         ///< linear (triangle) or bilinear (quad) between the corners
    glm::vec2 height_uv;  ///< where the corner vertex itself reads
    glm::vec4 edge_uv;    ///< where the edge to the next corner reads, linear between its begin (xy) and its end (zw)
};

/// Tessellation levels 1, 2, 4, ..., 64.
constexpr int level_octaves = 7;
/// Error of the chords at each of these levels, in heights. Non-increasing: it is the maximum over the level and all
/// finer ones. An error is three times the root mean square, or half the maximum if that is more. 99 % of the points
/// are within it, and no point is off by more than twice as much. (The maximum itself would cost a rough relief 1.4
/// times the triangles for the same error of 99 % of the pixels: patches differ in how rare their worst point is.)
using LevelErrors = std::array<float, level_octaves>;

struct PatchHeights {
    /// Lower and upper bound of any filtered height on the patch, its edges and its corners, at every mip level.
    /// Widened by 1/255 to absorb 8-bit rounding of map and filter.
    float lowest, highest;
    /// Upper bound of the change of the height at `uv` per metre of the flat patch, between any two of its points, at
    /// every mip level. Clamped to 1e6. A patch with degenerate positions and varying heights gets 1e6.
    float slope;
    LevelErrors inside;                 ///< of the evenly cut patch; for a quad, with the worse diagonal of each cell
    std::array<float, 4> edge_heights;  ///< the mean of the minimum and the maximum height of each edge
    std::array<LevelErrors, 4> edges;   ///< of edge i, from corner i to the next; a triangle has 3
};

/// Measures patches of `corners` points each, counter-clockwise: 3, or 4 at (0, 0), (1, 0), (1, 1), (0, 1) of the
/// domain. `heights` has one channel and repeats; its surface is bilinear between texel centres. Heights should be
/// finite; NaN heights are ignored. Most of the time goes into errors: without `with_errors` they are 0.
///
/// Errors are for mip level 0, and are sampled: 2 samples per texel inside and 8 on edges, at least 16 (64 on edges)
/// and at most densest_samples() (four times as many) along a side. So a relief with sharp features can have larger
/// errors between samples. A level with at most one sample between two vertices gets at least half the error of the
/// level before.
std::vector<PatchHeights> measure_patches(std::span<const HeightCorner> points, int corners, const Image& heights,
                                          bool with_errors = true);

/// Returns the maximum number of samples along a side for the errors of `patches` patches: a power of two from 16 to
/// 128. Chosen so that all patches together have at most 64 million samples, which take seconds, if 16 allow that.
int densest_samples(size_t patches);

}  // namespace relief
