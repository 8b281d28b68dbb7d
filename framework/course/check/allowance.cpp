#include "framework/course/check/allowance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace relief::check {
namespace {

/// The values of a channel of a pixel and its neighbours.
struct Range {
    float low = std::numeric_limits<float>::infinity(), high = -std::numeric_limits<float>::infinity();
    bool has_surface = false, has_background = false;
};

Range range_around(const Image& image, int x, int y, int channel) {
    Range range;
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, image.height - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, image.width - 1); ++column) {
            const float value = image.pixel(column, row)[channel];
            if (value == no_surface) {
                range.has_background = true;
            } else {
                range.has_surface = true;
                range.low = std::min(range.low, value);
                range.high = std::max(range.high, value);
            }
        }
    return range;
}

double length_of(const float* v) { return std::hypot(double(v[0]), double(v[1]), double(v[2])); }

}  // namespace

Rasteriser rasteriser_of(const std::string& renderer) {
    const auto has = [&](const char* name) { return renderer.find(name) != renderer.npos; };
    return has("llvmpipe") ? Rasteriser::exact : has("SwiftShader") ? Rasteriser::coarse : Rasteriser::usual;
}

Image with_allowance(Rasteriser rasteriser, const CheckInfo& check, ErrorMetric metric, const Image& drawn,
                     const Image& expected) {
    const bool same_shape =
        drawn.width == expected.width && drawn.height == expected.height && drawn.channels <= expected.channels;
    if (rasteriser == Rasteriser::exact || check.limits.at_least || !same_shape) return drawn;
    const bool is_coarse = rasteriser == Rasteriser::coarse;
    if (is_coarse && check.fine) return expected;
    const Image shifted = without_shifts(drawn, expected, metric, is_coarse ? 1 : 0.5f);
    return without_outliers(shifted, expected, metric, is_coarse ? 0.02 : 0.01);
}

Image without_shifts(const Image& drawn, const Image& expected, ErrorMetric metric, float pixels) {
    Image result = drawn;
    for (int y = 0; y < drawn.height; ++y)
        for (int x = 0; x < drawn.width; ++x) {
            const float *const from = drawn.pixel(x, y), *const exact = expected.pixel(x, y);
            float* const to = result.pixel(x, y);
            float scale = 1;
            if (metric == ErrorMetric::angle) scale = float(length_of(from) / length_of(exact));
            if (!(scale > 0) || !std::isfinite(scale)) scale = 1;
            for (int c = 0; c < drawn.channels; ++c) {
                const float value = from[c] / scale;
                if (value == exact[c] || std::isnan(value) || value == not_written) continue;
                const Range range = range_around(expected, x, y, c);
                if (value == no_surface || exact[c] == no_surface) {
                    if (range.has_surface && range.has_background) to[c] = exact[c];
                } else {
                    const float low = exact[c] + pixels * (range.low - exact[c]);
                    const float high = exact[c] + pixels * (range.high - exact[c]);
                    to[c] = scale * (exact[c] + (value - std::clamp(value, low, high)));
                }
            }
        }
    return result;
}

Image without_outliers(const Image& drawn, const Image& expected, ErrorMetric metric, double share) {
    const Image error = error_image(drawn, expected, metric);
    std::vector<size_t> order;
    for (size_t i = 0; i < error.values.size(); ++i)
        if (std::isfinite(error.values[i])) order.push_back(i);
    const auto count = std::ptrdiff_t(double(order.size()) * share);
    std::nth_element(order.begin(), order.begin() + count, order.end(),
                     [&](size_t a, size_t b) { return error.values[a] > error.values[b]; });
    Image result = drawn;
    for (auto i = order.begin(); i != order.begin() + count; ++i)
        std::copy_n(&expected.values[*i * size_t(expected.channels)], drawn.channels,
                    &result.values[*i * size_t(drawn.channels)]);
    return result;
}

}  // namespace relief::check
