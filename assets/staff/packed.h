// Gloss, height and occlusion of a surface in one map, from its colours and heights.
#pragma once

#include "assets/surface.h"

namespace relief {

/// Three channels of 8 bits, half as many texels along each side: red is gloss (bright places are worn smooth, and so
/// are high ones), green the height, blue how open the place is to the sky. `texels` is what a height of 1 is worth.
Image make_packed(const SurfaceMaps& maps, double texels);

/// Dark polished stone with pale veins: three channels, sRGB, 8 bits. It tiles.
Image make_marble();

}  // namespace relief
