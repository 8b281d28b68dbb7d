// Comparison of two pictures, or of a measured quantity with its exact values.
#pragma once

#include <cstddef>
#include <string>

#include "framework/core/image/image.h"

namespace relief {

/// Returns true when all pixels are the same, bit for bit. A blank picture must count as a failure, never as a pass.
bool is_one_color(const Image& image);

struct Difference {
    double largest = 0;      ///< maximum over all channels; infinite when a value is NaN or the shapes differ
    size_t pixels_over = 0;  ///< pixels with a channel that differs by more than the threshold
};
Difference difference(const Image& a, const Image& b, double threshold);

/// How the error of a measured value is computed: the Euclidean distance over the channels; the angle between two
/// vectors in degrees, by atan2 of cross and dot product; or the absolute difference of the first channel.
enum class ErrorMetric { distance, angle, absolute };

/// Returns the error of each pixel, in one channel. It is NaN where a value is NaN or, for an angle, a vector is zero;
/// not_written where the measured value is; and +infinity where either has no surface. Throws Error when the shapes
/// differ, or when an angle has less than three channels.
Image error_image(const Image& measured, const Image& truth, ErrorMetric metric);

/// Statistics over the pixels with a surface in both images; all zero when there are none.
struct ErrorSummary {
    size_t count = 0;  ///< pixels compared
    double mean = 0, rms = 0, p99 = 0, largest = 0;
    size_t not_finite = 0;  ///< pixels that are NaN: always a mistake
    size_t missing = 0;     ///< pixels that are not_written
};
ErrorSummary summarize(const Image& error);

/// Pixels with a surface in only one of two images. error_image() has no number for them, but they disagree.
struct OneSided {
    size_t measured = 0, truth = 0;
    size_t count() const { return measured + truth; }
};
/// Counts pixels with a surface in only one of the two images. Precondition: the images have the same shape.
OneSided one_sided(const Image& measured, const Image& truth);
/// Sets pixels with a surface in only one of the two images to the error `value`.
void mark_one_sided(Image& error, const Image& measured, const Image& truth, double value);
/// Returns why summarize() found no pixel to compare, as a sentence without its full stop; empty if there is such a
/// pixel.
std::string nothing_to_compare(const Image& measured, const Image& truth, const ErrorSummary& summary);

}  // namespace relief
