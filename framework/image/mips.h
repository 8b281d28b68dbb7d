// Mip chains, of colours and of normals.
#pragma once

#include <vector>

#include "framework/image/image.h"

namespace relief {

/// Level 0 (the image) down to 1x1, each level half the size of the one before, rounded down. A texel is the mean of
/// the area it covers, also where a side is odd; sRGB colour is averaged as light (alpha is never sRGB).
std::vector<Image> mip_chain(Image image, ColorSpace space);

/// The chain of a normal map (3 channels of 0.5 n + 0.5, or 4 of which the fourth does not count): each level holds the
/// mean of the unit normals below it, normalised again, as 0.5 n + 0.5, and in a fourth channel the length that the
/// mean had: 1 where all agree. Averaged normals are right for diffuse light; for highlights the length says how much
/// they differed. Where they cancel out the normal is straight up, and the length 0. Takes 28 bytes a texel of level 0.
std::vector<Image> normal_mip_chain(const Image& normals);

/// Toksvig's factor (2004), length / (length + shininess (1 - length)): a Blinn-Phong highlight of an averaged normal
/// has `shininess` times this. From lengths that are stored in 8 bits it is no more than a guess at high shininess: at
/// 512 the one step from 255 to 254 makes 1 into 0.33.
double toksvig_factor(double length, double shininess);

}  // namespace relief
