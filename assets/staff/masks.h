// Lab 08's masks from their formulas, the ivy's colours, and the bricks' highlights.
#pragma once

#include "framework/core/image/image.h"

namespace relief {

/// Returns the coverage of each texel by the wires or the leaves: 1 channel of 8 bits, 512 x 512 texels, 16 x 16
/// samples each.
Image make_wire_mask();
Image make_leaf_mask();
/// Returns the ivy's colours, also where it has no leaf: 3 channels, sRGB, 8 bits.
Image make_leaf_colors();
/// Returns the colours with the coverage in the fourth channel, 256 x 256 texels: the means of 2 x 2 of the others.
Image make_leaves_with_alpha();
/// Returns the colour of the bricks' highlight, and its exponent / 256 in the fourth channel; linear, 8 bits, 512 x
/// 512.
Image make_brick_highlights();

}  // namespace relief
