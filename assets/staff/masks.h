// Lab 08's masks from their formulas, the ivy's colours, and how the bricks shine.
#pragma once

#include "framework/image/image.h"

namespace relief {

/// Share of each texel that the wires, or the leaves, cover: 1 channel of 8 bits, 512 x 512, from 16 x 16 places.
Image make_wire_mask();
Image make_leaf_mask();
/// Of the ivy, also where it has no leaf: 3 channels, sRGB, 8 bits.
Image make_leaf_colors();
/// The colour of the bricks' highlight, and its exponent / 256 in the fourth channel; linear, 8 bits, 512 x 512.
Image make_brick_highlights();

}  // namespace relief
