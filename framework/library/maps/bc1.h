// BC1 (S3TC, DXT1): colours in blocks of 4 x 4 texels, with 4 bits a texel.
#pragma once

#include "framework/core/image/image.h"

namespace relief {

/// Returns an RGB picture as BC1 gives it back. Each block has two colours of 5, 6 and 5 bits and, for each texel, one
/// index to the 4 colours on the line between them. Three channels share the index. The ends are the outermost texels
/// along the block's principal axis (range fit). Blocks begin at the lower left corner, and repeat the last column or
/// row beyond the border. Values are clamped to [0, 1]; NaN counts as 0. Precondition: three channels.
Image through_bc1(const Image& picture);

}  // namespace relief
