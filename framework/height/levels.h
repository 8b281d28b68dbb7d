// The error bounds of a height map's mip levels, for a march that reads a coarse one.
#pragma once

#include <vector>

#include "framework/image/image.h"

namespace relief {

/// For each level of mip_chain() the most that a march through it, a step a texel of that level, can be off, in
/// heights; never falling. That is the most that the level's bilinear surface is apart from that of level 0, anywhere,
/// and the most that it can leave the straight line between two places that are a texel apart. Level 0 comes always,
/// others as long as they are off by less than `enough`. `heights` has one channel and repeats; its sides are powers of
/// two.
std::vector<float> level_errors(const Image& heights, float enough);

/// For each k the most that bilinear pieces of 2^k x 2^k texels whose corners lie on the surface are off, with the
/// worse of the two diagonals when they are cut in triangles; never falling. The corners of texels are theirs. The
/// smallest come always, others as long as they are off by less than `enough`.
std::vector<float> piece_errors(const Image& heights, float enough);

}  // namespace relief
