// Normal maps from height maps.
#pragma once

#include "framework/height/lines.h"
#include "framework/image/image.h"

namespace relief {

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
