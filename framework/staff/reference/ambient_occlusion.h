// Ambient occlusion by horizons, in double precision.
#pragma once

#include <functional>

#include "framework/core/image/image.h"

namespace relief {

/// Returns the share of a slice's cosine-weighted light that remains between two horizons. h1 <= 0 <= h2 are measured
/// from the view direction; `g` is the angle of the normal; all are in radians (Jimenez et al. 2016). Horizons are
/// clamped to the hemisphere of the normal.
double open_share(double h1, double h2, double g);

/// Returns the openness of each texel to the sky above a relief that tiles; 1 is open. Samples `slices` vertical planes
/// through the texel and the heights within `reach` texels. `texels` is the size of height 1 in texels. One channel of
/// floats. `before_part` is called before each part of the work, with its index and the number of parts.
Image occlusion_from_heights(const Image& heights, double texels, int slices, int reach,
                             const std::function<void(int part, int parts)>& before_part = {});

}  // namespace relief
