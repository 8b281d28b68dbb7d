#include "framework/core/image/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "framework/core/base/error.h"

namespace relief {

bool is_one_color(const Image& image) {
    const float* const first = image.values.data();
    const size_t bytes = image.channels * sizeof(float);
    for (size_t i = 1; i < image.pixel_count(); ++i)
        if (std::memcmp(first, first + i * image.channels, bytes) != 0) return false;
    return true;
}

Difference difference(const Image& a, const Image& b, double threshold) {
    if (!a.same_shape(b)) return {INFINITY, std::max(a.pixel_count(), b.pixel_count())};
    Difference result;
    for (size_t i = 0; i < a.pixel_count(); ++i) {
        double largest = 0;
        for (int c = 0; c < a.channels; ++c) {
            const float x = a.values[i * a.channels + c], y = b.values[i * a.channels + c];
            if (x == y) continue;  // also for two equal infinities
            const double off = std::abs(static_cast<double>(x) - y);
            largest = std::max(largest, std::isnan(off) ? INFINITY : off);
        }
        result.largest = std::max(result.largest, largest);
        if (largest > threshold) ++result.pixels_over;
    }
    return result;
}

namespace {

bool has_surface(const Image& image, size_t pixel) {
    return image.values[pixel * size_t(image.channels)] != no_surface;
}

double angle_degrees(const float* a, const float* b) {
    const double x = double(a[1]) * b[2] - double(a[2]) * b[1], y = double(a[2]) * b[0] - double(a[0]) * b[2],
                 z = double(a[0]) * b[1] - double(a[1]) * b[0];
    const double dot = double(a[0]) * b[0] + double(a[1]) * b[1] + double(a[2]) * b[2];
    const double sine = std::sqrt(x * x + y * y + z * z);
    // A zero vector has no direction; atan2(0, 0) would call it exact.
    return sine == 0 && dot == 0 ? NAN : std::atan2(sine, dot) * 180 / std::numbers::pi;
}

double distance(const float* a, const float* b, int channels) {
    double sum = 0;
    for (int c = 0; c < channels; ++c) sum += (double(a[c]) - b[c]) * (double(a[c]) - b[c]);
    return std::sqrt(sum);
}

}  // namespace

Image error_image(const Image& measured, const Image& truth, ErrorMetric metric) {
    if (!measured.same_shape(truth))
        throw Error("a probe and its truth must have the same size and number of channels");
    if (metric == ErrorMetric::angle && measured.channels < 3) throw Error("an angle needs three channels");
    Image result(measured.width, measured.height, 1);
    for (size_t i = 0; i < result.pixel_count(); ++i) {
        const float* const m = measured.values.data() + i * measured.channels;
        const float* const t = truth.values.data() + i * truth.channels;
        double error = no_surface;
        const bool is_nan = std::any_of(m, m + measured.channels, [](float v) { return std::isnan(v); });
        if (is_nan)
            error = NAN;
        else if (m[0] == not_written)
            error = not_written;
        else if (!std::isinf(m[0]) && !std::isinf(t[0]))
            switch (metric) {
                case ErrorMetric::angle:
                    error = angle_degrees(m, t);
                    break;
                case ErrorMetric::distance:
                    error = distance(m, t, measured.channels);
                    break;
                case ErrorMetric::absolute:
                    error = distance(m, t, 1);
                    break;
            }
        result.values[i] = static_cast<float>(error);
    }
    return result;
}

ErrorSummary summarize(const Image& error) {
    ErrorSummary summary;
    std::vector<float> errors;
    double sum = 0, squares = 0;
    for (const float value : error.values) {
        if (std::isnan(value)) ++summary.not_finite;
        if (value == not_written) ++summary.missing;
        if (!std::isfinite(value)) continue;
        errors.push_back(value);
        sum += value, squares += double(value) * value;
    }
    if (errors.empty()) return summary;
    summary.count = errors.size();
    summary.mean = sum / errors.size();
    summary.rms = std::sqrt(squares / errors.size());
    // The smallest value that at least 99 % of the pixels do not exceed.
    const size_t rank = static_cast<size_t>(std::ceil(0.99 * errors.size())) - 1;
    std::nth_element(errors.begin(), errors.begin() + rank, errors.end());
    summary.p99 = errors[rank];
    summary.largest = *std::max_element(errors.begin() + rank, errors.end());
    return summary;
}

OneSided one_sided(const Image& measured, const Image& truth) {
    OneSided found;
    for (size_t i = 0; i < measured.pixel_count(); ++i) {
        const bool in_measured = has_surface(measured, i), in_truth = has_surface(truth, i);
        found.measured += in_measured && !in_truth;
        found.truth += in_truth && !in_measured;
    }
    return found;
}

void mark_one_sided(Image& error, const Image& measured, const Image& truth, double value) {
    for (size_t i = 0; i < error.pixel_count(); ++i)
        if (error.values[i] == no_surface && has_surface(measured, i) != has_surface(truth, i))
            error.values[i] = static_cast<float>(value);
}

std::string nothing_to_compare(const Image& measured, const Image& truth, const ErrorSummary& summary) {
    if (summary.count > 0) return "";
    if (summary.missing > 0) return fmt::format("{} pixels come from a task that is not written yet", summary.missing);
    if (summary.not_finite > 0)
        return fmt::format(
            "no pixel can be compared: {} are not a number or have no direction, as they are drawn or in "
            "the expected values",
            summary.not_finite);
    const OneSided found = one_sided(measured, truth);
    if (found.count() == 0) return "no pixel can be compared: there is no surface in the picture";
    return fmt::format(
        "no pixel can be compared: {} have a surface only as it is drawn, {} only in the expected values",
        found.measured, found.truth);
}

}  // namespace relief
