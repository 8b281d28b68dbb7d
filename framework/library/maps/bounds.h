// The minimum and maximum heights of a relief, region by region, for searches along a ray.
#pragma once

#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// Returns the min-max mip chain of a one-channel height map that repeats. Each level has two channels, the minimum and
/// the maximum height. Level 0 has one texel per bilinear cell: the square between the centre of this texel and the
/// centres of its neighbours to the right and above. Each level is half the size of the one before, rounded down, to
/// 1x1. Texel i of M along a side of N cells bounds every cell that overlaps [i N / M, (i + 1) N / M]: 2^k x 2^k cells
/// on level k where N is a power of two. Bounds include the far corners of the cells, so they hold for the whole
/// surface.
std::vector<Image> min_max_mips(const Image& heights);

/// Returns all levels of min_max_mips() in one image, to be used as one texture. Level 0 is at the lower left. Beside
/// it, from the bottom up, are levels 1, 2, ...: level k begins W columns to the right and H - H / 2^(k - 1) rows up,
/// where the map is W x H. Mip levels of a texture would not do: the four pixels of a quad may need different levels,
/// and a renderer may fetch the same level for all four. Throws Error when the map is not square with a power of two as
/// its side, or has more than one channel.
Image min_max_atlas(const Image& heights);

}  // namespace relief
