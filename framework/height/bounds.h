// The minimum and maximum heights of a relief, region by region, for searches along a ray.
#pragma once

#include <vector>

#include "framework/image/image.h"

namespace relief {

/// Of a one-channel height map that repeats: two channels, the lowest and the highest height. Level 0 has a texel for
/// each bilinear cell, the one between this texel's centre and those of its neighbours to the right and above; each
/// level is half the size of the one before, rounded down, to 1x1. Texel i of the M along a side of N holds the cells
/// i N / M to (i + 1) N / M, those in part as well: 2^k x 2^k of them on level k where N is a power of two. Their far
/// corners count, so the surface leaves the bounds nowhere.
std::vector<Image> min_max_mips(const Image& heights);

/// All those levels in one image, for a texture: level 0 at its lower left, beside it level 1 above level 2 above ...,
/// so that level k begins W columns to the right and H - H / 2^(k - 1) rows up, where the map is W x H. Four
/// neighbouring pixels of a shader may want different levels, and of a texture's own levels a renderer may fetch the
/// same for all four. Throws Error when the map is not square with a power of two as its side.
Image min_max_atlas(const Image& heights);

}  // namespace relief
