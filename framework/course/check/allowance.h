// What a check allows for the renderer where it cannot choose one: in a browser, and in a window on a GPU. Renderers
// draw a surface at slightly different places, and differ in their filters and derivatives.
#pragma once

#include <string>

#include "framework/core/image/compare.h"
#include "framework/core/image/image.h"
#include "framework/core/lab/manifest.h"

namespace relief::check {

/// How a renderer draws: `exact` like the one that drew the expected pictures (Mesa's llvmpipe); `usual` like a GPU;
/// `coarse` with vertices on a grid of 1/16 pixel, 16 times as wide as usual (SwiftShader), which changes the slopes of
/// surfaces that are seen from the side.
enum class Rasteriser { exact, usual, coarse };
Rasteriser rasteriser_of(const std::string& renderer);

/// Returns the picture to judge instead of `drawn`. `exact`: `drawn` itself. `usual`: without_shifts() of half a pixel,
/// then without_outliers() of 1 %. `coarse`: of a whole pixel and of 2 %; and `expected` for a check that is `fine`.
/// Two pictures that must differ (Limits::at_least) are judged as they are, and so are pictures of different shapes.
Image with_allowance(Rasteriser rasteriser, const CheckInfo& check, ErrorMetric metric, const Image& drawn,
                     const Image& expected);

/// Returns `drawn` without the part of each pixel's error that a shift of the picture by `pixels` (0 to 1) can explain.
/// The expected pixel and its eight neighbours span a range in each channel. Towards the pixel's own value, the range
/// is shortened to the share `pixels`. A value in that range becomes the expected value. A value outside of it keeps
/// its distance from the range as its error. So errors count in full where the expected picture is smooth, and less
/// along its edges and in its noise. Directions (ErrorMetric::angle) keep their length. A surface in only one of both
/// pictures is allowed where the expected picture has an outline. NaN and not_written stay. Precondition: the same
/// width and height, and the channels that the metric reads.
Image without_shifts(const Image& drawn, const Image& expected, ErrorMetric metric, float pixels);

/// Returns `drawn` with the expected values in the `share` of its pixels whose errors are largest, for checks that
/// limit the largest error. NaN and not_written stay, and so do surfaces in only one of both pictures.
Image without_outliers(const Image& drawn, const Image& expected, ErrorMetric metric, double share);

}  // namespace relief::check
