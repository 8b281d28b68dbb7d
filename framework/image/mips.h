// Mip chains.
#pragma once

#include <vector>

#include "framework/image/image.h"

namespace relief {

/// Level 0 (the image) down to 1x1, each level half the size of the one before, rounded down. A texel is the mean of
/// the area it covers, also where a side is odd; sRGB colour is averaged as light (alpha is never sRGB).
std::vector<Image> mip_chain(Image image, ColorSpace space);

}  // namespace relief
