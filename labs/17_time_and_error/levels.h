// The error bounds of a height map's mip levels, for a march that reads a coarse one.
#pragma once

#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// Returns for each level of mip_chain() an upper bound of the error of a march with one step per texel of that level,
/// in heights. Non-decreasing. The bound is the sum of two maxima. One is the difference of the level's bilinear
/// surface from that of level 0. The other is its distance from a chord one texel long. Level 0 is always included, and
/// further levels while their error is below `enough`. `heights` has one channel and repeats; its sides are powers of
/// two.
std::vector<float> level_errors(const Image& heights, float enough);

/// Returns for each k an upper bound of the error of bilinear pieces of 2^k x 2^k texels, in heights. Non-decreasing.
/// The corners of the pieces lie on the surface, at corners of texels. The bound also holds for pieces that are cut
/// into two triangles along either diagonal. The smallest pieces (k = 0) are always included, and larger ones while
/// their error is below `enough`. `heights` is as for level_errors().
std::vector<float> piece_errors(const Image& heights, float enough);

}  // namespace relief
