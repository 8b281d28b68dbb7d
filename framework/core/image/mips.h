// Mip chains of colours and of normals.
#pragma once

#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// Returns level 0 (the image) down to 1x1. Each level is half the size of the one before, rounded down. A texel is the
/// mean of the area that it covers, also where a side is odd. sRGB colour is averaged as light; alpha is never sRGB.
std::vector<Image> mip_chain(Image image, ColorSpace space);

/// Returns the mip chain of a normal map with 3 channels of 0.5 n + 0.5; a fourth is ignored. Each level holds the mean
/// of the unit normals that it covers, normalised again, as 0.5 n + 0.5. A fourth channel holds the length of the mean:
/// 1 where all normals agree. Averaged normals are right for diffuse light. For highlights, the length tells how much
/// the normals differ. Where they cancel out, the normal points straight up and the length is 0. Takes 28 bytes per
/// texel of level 0.
std::vector<Image> normal_mip_chain(const Image& normals);

/// Returns the factor of Toksvig (2005), length / (length + shininess (1 - length)). A Blinn-Phong highlight of an
/// averaged normal has `shininess` times this factor. With lengths stored in 8 bits it is only a guess at high
/// shininess: at 512, the step from 255 to 254 changes it from 1 to 0.33. A length of 0 gives 0.
double toksvig_factor(double length, double shininess);

/// Returns a gloss map: toksvig_factor() of the mean of the 3 x 3 normals around each texel, in one channel. It is 1
/// where they agree. `normals` has three channels in [-1, 1], none of length 0, and tiles.
Image gloss_of(const Image& normals, double shininess);

}  // namespace relief
