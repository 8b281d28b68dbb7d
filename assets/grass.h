// A lawn from above.
#pragma once

#include "framework/core/image/image.h"

namespace relief {

constexpr int grass_texels = 512;

/// Returns its diffuse colour: 3 channels, sRGB, 8 bits. Tiles.
Image make_grass();

}  // namespace relief
