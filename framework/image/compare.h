// Comparison of two pictures, or of a measured quantity with its exact values.
#pragma once

#include <cstddef>
#include <string>

#include "framework/image/image.h"

namespace relief {

/// True when every pixel is the same: a blank picture is a failure, never a pass.
bool is_one_color(const Image& image);

struct Difference {
    double largest = 0;      ///< over all channels; infinite when a value is NaN or the shapes differ
    size_t pixels_over = 0;  ///< pixels with a channel off by more than the threshold
};
Difference difference(const Image& a, const Image& b, double threshold);

/// How far a measured value is from the truth: Euclidean over the channels; the angle between two vectors in
/// degrees, by atan2 of cross and dot product; or the absolute difference of the first channel.
enum class ErrorMetric { distance, angle, absolute };

/// One channel: the error of each pixel, +infinity where either has no surface, NaN where either is NaN or, for an
/// angle, zero, and not_written where the measured value is. The shapes must agree.
Image error_image(const Image& measured, const Image& truth, ErrorMetric metric);

/// Over the pixels with a surface; all zero when there are none.
struct ErrorSummary {
    size_t count = 0;  ///< pixels compared
    double mean = 0, rms = 0, p99 = 0, largest = 0;
    size_t not_finite = 0;  ///< pixels that are NaN: always a mistake
    size_t missing = 0;     ///< pixels that are not_written
};
ErrorSummary summarize(const Image& error);

}  // namespace relief
