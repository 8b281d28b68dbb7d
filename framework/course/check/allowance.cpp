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

    void add(float value) {
        if (value == no_surface) {
            has_background = true;
        } else {
            has_surface = true;
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
};

Range range_around(const Image& image, int x, int y, int channel) {
    Range range;
    for (int row = std::max(y - 1, 0); row <= std::min(y + 1, image.height - 1); ++row)
        for (int column = std::max(x - 1, 0); column <= std::min(x + 1, image.width - 1); ++column)
            range.add(image.pixel(column, row)[channel]);
    return range;
}

double length_of(const float* v) { return std::hypot(double(v[0]), double(v[1]), double(v[2])); }

/// Returns the factor by which a vector is longer than the exact one, for angles; 1 for other metrics.
float scale_of(const float* vector, const float* exact, ErrorMetric metric) {
    const float scale = metric == ErrorMetric::angle ? float(length_of(vector) / length_of(exact)) : 1;
    return scale > 0 && std::isfinite(scale) ? scale : 1;
}

/// Returns for each pixel whether all pictures have the same values there.
std::vector<bool> equal_pixels(const Image& picture, const std::vector<Image>& others) {
    std::vector<bool> equal(picture.pixel_count(), true);
    for (const Image& other : others)
        for (size_t i = 0; i < picture.values.size(); ++i)
            if (picture.values[i] != other.values[i]) equal[i / size_t(picture.channels)] = false;
    return equal;
}

}  // namespace

Rasteriser rasteriser_of(const std::string& renderer) {
    const auto has = [&](const char* name) { return renderer.find(name) != renderer.npos; };
    return has("llvmpipe") ? Rasteriser::exact : has("SwiftShader") ? Rasteriser::coarse : Rasteriser::usual;
}

Image with_allowance(Rasteriser rasteriser, const CheckInfo& check, ErrorMetric metric, const Image& drawn,
                     const Image& expected, const std::vector<Image>& moved) {
    const bool same_shape =
        drawn.width == expected.width && drawn.height == expected.height && drawn.channels <= expected.channels;
    if (rasteriser == Rasteriser::exact || check.limits.at_least || !same_shape) return drawn;
    if (rasteriser == Rasteriser::usual)
        return without_outliers(without_shifts(drawn, expected, metric, 0.5f), expected, metric, 0.01);
    const Image steady = without_rounding(drawn, moved, expected, metric);
    return without_outliers(without_shifts(steady, expected, metric, 0.125f), expected, metric, 0.02,
                            check.shot.probe ? equal_pixels(drawn, moved) : std::vector<bool>());
}

Image without_rounding(const Image& drawn, const std::vector<Image>& moved, const Image& expected, ErrorMetric metric) {
    constexpr float margin = 0.25f;
    Image result = drawn;
    const size_t channels = size_t(drawn.channels);
    for (size_t i = 0; i < drawn.pixel_count(); ++i) {
        const float *const from = &drawn.values[i * channels], *const exact =
                                                                   &expected.values[i * size_t(expected.channels)];
        float* const to = &result.values[i * channels];
        const float scale = scale_of(from, exact, metric);
        for (size_t c = 0; c < channels; ++c) {
            if (std::isnan(from[c]) || from[c] == not_written) continue;
            Range range;
            range.add(from[c] / scale);
            for (const Image& other : moved) {
                const float* const vector = &other.values[i * channels];
                range.add(vector[c] / scale_of(vector, exact, metric));
            }
            if (from[c] == no_surface || exact[c] == no_surface) {
                if (range.has_surface && range.has_background) to[c] = exact[c];
            } else {
                const float wider = margin * (range.high - range.low);
                to[c] = scale * std::clamp(exact[c], range.low - wider, range.high + wider);
            }
        }
    }
    return result;
}

Image without_shifts(const Image& drawn, const Image& expected, ErrorMetric metric, float pixels) {
    Image result = drawn;
    for (int y = 0; y < drawn.height; ++y)
        for (int x = 0; x < drawn.width; ++x) {
            const float *const from = drawn.pixel(x, y), *const exact = expected.pixel(x, y);
            float* const to = result.pixel(x, y);
            const float scale = scale_of(from, exact, metric);
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

Image without_outliers(const Image& drawn, const Image& expected, ErrorMetric metric, double share,
                       const std::vector<bool>& stays) {
    const Image error = error_image(drawn, expected, metric);
    std::vector<size_t> order;
    size_t compared = 0;
    for (size_t i = 0; i < error.values.size(); ++i) {
        if (!std::isfinite(error.values[i])) continue;
        ++compared;
        if (stays.empty() || !stays[i]) order.push_back(i);
    }
    const auto count = std::ptrdiff_t(std::min(size_t(double(compared) * share), order.size()));
    std::nth_element(order.begin(), order.begin() + count, order.end(),
                     [&](size_t a, size_t b) { return error.values[a] > error.values[b]; });
    Image result = drawn;
    for (auto i = order.begin(); i != order.begin() + count; ++i)
        std::copy_n(&expected.values[*i * size_t(expected.channels)], drawn.channels,
                    &result.values[*i * size_t(drawn.channels)]);
    return result;
}

}  // namespace relief::check
