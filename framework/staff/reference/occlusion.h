// Ambient occlusion by horizons, in double precision.
#pragma once

#include "framework/image/image.h"

namespace relief {

/// The share of the cosine-weighted light of a slice that is left between two horizons: h1 <= 0 <= h2 are measured from
/// the direction of view, `g` is the angle of the normal, all in radians (Jimenez et al. 2016). Horizons beyond the
/// hemisphere of the normal count as its edge.
double open_share(double h1, double h2, double g);

/// How open each texel of a relief that tiles is to the sky over it, by `slices` vertical planes through it and the
/// heights within `reach` texels: 1 is open. `texels` is what a height of 1 is worth. One channel of floats.
Image occlusion_from_heights(const Image& heights, double texels, int slices, int reach);

}  // namespace relief
