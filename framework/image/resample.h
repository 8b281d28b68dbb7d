// Maps in another number of texels.
#pragma once

#include "framework/image/image.h"

namespace relief {

/// The image, which tiles, in `width` x `height` texels, both at least 1: the mean under a tent that is as wide as two
/// texels of the coarser of the two. Texels that stay as many stay as they are. Values are numbers: take light for
/// colours. In floats, whatever the bits.
Image resampled(const Image& image, int width, int height);

}  // namespace relief
