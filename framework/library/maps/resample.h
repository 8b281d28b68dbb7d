// Resampling of maps to another number of texels.
#pragma once

#include "framework/core/image/image.h"

namespace relief {

/// Returns the image, which tiles, resampled to `width` x `height` texels, both at least 1. The filter is a tent that
/// is two texels of the coarser of the two images wide. An axis whose size stays the same keeps its values. Values are
/// averaged as plain numbers, so convert colours to light first. The result always has 32 bits.
Image resampled(const Image& image, int width, int height);

}  // namespace relief
