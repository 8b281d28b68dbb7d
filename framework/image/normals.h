// Normal maps from height maps.
#pragma once

#include "framework/image/image.h"

namespace relief {

enum class SlopeFilter {
    central,  ///< (h(+1) - h(-1)) / 2; second order
    sobel     ///< central, smoothed across by (1 2 1) / 4; less noise from 8-bit heights, flatter slopes
};

struct NormalOptions {
    /// What height 1 is worth, in texels along u and along v (they differ where texels are not square).
    double texels_u = 1;
    double texels_v = 1;
    SlopeFilter filter = SlopeFilter::central;
    /// Beyond the border: the other side (a tile), or the border texel again.
    bool wrap = true;
};

/// The unit normals (-dh/du, -dh/dv, 1) of a one-channel height map as a 3-channel map of `0.5 n + 0.5`: v
/// grows up, so green is up. The result's precision is 8 bits; it is not yet rounded.
Image normals_from_heights(const Image& heights, const NormalOptions& options);

}  // namespace relief
