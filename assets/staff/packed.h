// Gloss, height and occlusion of a surface in one map, from its colours and heights.
#pragma once

#include "assets/surface.h"

namespace relief {

/// Returns three channels of 8 bits at half the resolution. Red is gloss: bright and high places are worn smooth. Green
/// is the height, blue the openness to the sky. `texels` is the size of height 1 in texels.
Image make_packed(const SurfaceMaps& maps, double texels);

/// Returns dark polished stone with pale veins: three channels, sRGB, 8 bits. Tiles.
Image make_marble();

}  // namespace relief
