// Normal maps from height maps.
#pragma once

#include <vector>

#include "framework/image/image.h"

namespace relief {

/// How the slope dh/du of a row of heights is taken at a texel; along v likewise. On a clean height map, the mean error
/// of the normal at 8 texels a wavelength and slopes up to 1 stands beside it, in degrees; noise is what the slope's
/// rms is per unit rms of the heights' (rounding to 8 bits is noise).
enum class SlopeFilter {
    forward,       ///< h(+1) - h(0); first order, and shifts the relief by half a texel; noise 1.41
    central,       ///< (h(+1) - h(-1)) / 2; second order; 1.83 degrees, noise 0.71
    sobel,         ///< central, smoothed across by (1 2 1) / 4; 2.61 degrees, noise 0.43
    scharr,        ///< central, smoothed across by (3 10 3) / 16: keeps directions; 2.39 degrees, noise 0.48
    fourth_order,  ///< (8 (h(+1) - h(-1)) - (h(+2) - h(-2))) / 12; 0.18 degrees, noise 0.95
    spline         ///< of the cubic spline through all heights, m(-1) + 4 m + m(+1) = 3 (h(+1) - h(-1)); 0.034 degrees
};

struct NormalOptions {
    /// What height 1 is worth, in texels along u and along v (they differ where texels are not square).
    double texels_u = 1;
    double texels_v = 1;
    SlopeFilter filter = SlopeFilter::central;
    /// Beyond the border: the other side (a tile), or nothing. Then slopes at the border are one-sided and of the
    /// filter's order where the map has enough texels, and smoothing across repeats the border.
    bool wrap = true;
    /// How strong each level of detail is, from the finest: level k is what changes over about 2^k texels (the
    /// difference of two smoothings by the cubic B-spline, as in an undecimated wavelet transform); what is coarser
    /// than all of them keeps its strength. Empty, or all 1, changes nothing.
    std::vector<double> level_strengths = {};
};

/// The unit normals (-dh/du, -dh/dv, 1) of a one-channel height map as a 3-channel map of `0.5 n + 0.5`: v
/// grows up, so green is up. The result's precision is 8 bits; it is not yet rounded. Within 6e-7 of double precision
/// at slopes up to 3, and the same for any number of threads and on any x86-64. A slope that is not a number, from
/// heights that are not, counts as 0; a steeper one than 1e18 as that. Takes 16 bytes a texel (4 read, 12 written),
/// with `spline` 4 more, with `level_strengths` 16 more.
Image normals_from_heights(const Image& heights, const NormalOptions& options);

/// The same into an image that is there: its memory is used again when it has that size. `threads` 0: all.
void normals_from_heights(const Image& heights, const NormalOptions& options, Image& normals, unsigned threads = 0);

/// A height map from a picture: its relative luminance (Rec. 709, of light), kept as sRGB stores grey. So a grey
/// picture gives its own values back, and what looks half as bright is half as high. 1 to 4 channels; alpha does not
/// count.
Image heights_from_color(const Image& color, ColorSpace space);

}  // namespace relief
