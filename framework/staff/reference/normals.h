// Normal maps from height maps.
#pragma once

#include "framework/core/image/image.h"
#include "framework/library/maps/line_slopes.h"

namespace relief {

/// Returns a normal map, 0.5 n + 0.5 in 3 channels, of a one-channel height map. n is (-dh/du, -dh/dv, 1), normalised;
/// v grows up, so green is up. The image says 8 bits, but its values are not yet rounded. At slopes up to 3 they are
/// within 6e-7 of double precision. The result does not depend on the number of threads or the x86-64 processor. A NaN
/// slope counts as 0. Slopes beyond 1e18 are scaled down together, so that the larger one is 1e18. Memory traffic is 16
/// bytes per texel (4 read, 12 written), 4 more with `spline`, 16 more with `level_strengths`.
Image normals_from_heights(const Image& heights, const NormalOptions& options);

/// Writes into an existing image; its memory is reused if the size fits. `threads` 0: one per processor.
void normals_from_heights(const Image& heights, const NormalOptions& options, Image& normals, unsigned threads = 0);

/// Writes rows `first` to `first` + normals.height - 1 of that normal map, with the same bits. `normals` has the width
/// of the heights and three channels. Preconditions: the filter is not `spline`, and there are no level strengths.
void normals_of_rows(const Image& heights, const NormalOptions& options, int first, Image& normals);

/// Returns a height map from a picture of 1 to 4 channels; alpha is ignored. The height is the relative luminance (Rec.
/// 709, of linear light), encoded as sRGB grey. So a grey picture keeps its values, and heights are perceptually
/// uniform.
Image heights_from_color(const Image& color, ColorSpace space);

}  // namespace relief
