#include "framework/image/visualize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace relief {
namespace {

using Color = std::array<float, 3>;
constexpr Color nothing{0.11f, 0.12f, 0.14f}, not_a_number{1, 0, 1}, missing{0.85f, 0, 0.85f};

void put(Image& image, size_t i, const Color& color) {
    std::copy(color.begin(), color.end(), image.values.begin() + std::ptrdiff_t(i * 3));
}

/// Returns the colour of a value that is NaN, not written or infinite, or null for any other value.
const Color* special_color(const float* value, int channels) {
    if (std::any_of(value, value + channels, [](float v) { return std::isnan(v); })) return &not_a_number;
    if (std::count(value, value + channels, not_written) == channels) return &missing;
    if (std::any_of(value, value + channels, [](float v) { return std::isinf(v); })) return &nothing;
    return nullptr;
}

using Scale = std::array<Color, 6>;
// Lightness increases steadily along both scales, so they can be read without colour too.
constexpr Scale warm = {{{0.00f, 0.00f, 0.02f},
                         {0.26f, 0.04f, 0.41f},
                         {0.58f, 0.15f, 0.40f},
                         {0.87f, 0.32f, 0.23f},
                         {0.99f, 0.65f, 0.04f},
                         {0.99f, 1.00f, 0.65f}}};
constexpr Scale cold = {{{0.00f, 0.00f, 0.02f},
                         {0.02f, 0.13f, 0.38f},
                         {0.03f, 0.32f, 0.58f},
                         {0.05f, 0.54f, 0.75f},
                         {0.29f, 0.77f, 0.87f},
                         {0.75f, 0.98f, 0.98f}}};

Color color_on(const Scale& scale, double share) {
    const double place = std::clamp(share, 0.0, 1.0) * (scale.size() - 1);
    const size_t below = std::min(size_t(place), scale.size() - 2);
    Color color;
    for (size_t c = 0; c < 3; ++c)
        color[c] = std::lerp(scale[below][c], scale[below + 1][c], float(place - double(below)));
    return color;
}

Color heat(double share) { return color_on(warm, share); }

}  // namespace

glm::dvec3 heat_color(double share) {
    const Color color = heat(share);
    return {color[0], color[1], color[2]};
}

Image visualize_probe(const Image& probe, ProbeColors colors) {
    const ErrorMetric metric = colors.error;
    const int channels = std::min(probe.channels, 3);
    std::vector<double> sizes;
    for (const float value : probe.values)
        if (std::isfinite(value) && value != 0) sizes.push_back(std::abs(value));
    std::sort(sizes.begin(), sizes.end());
    const double largest = sizes.empty() ? 1 : sizes.back();
    // About sixteen bands between 0 and the median. With texture coordinates, a band is then typically one tile.
    const double band = sizes.empty() ? 1 : std::exp2(std::ceil(std::log2(sizes[sizes.size() / 2] / 16)));

    const auto channel_of = [&](float value) {
        if (metric == ErrorMetric::angle) return std::clamp(0.5f * value + 0.5f, 0.0f, 1.0f);
        const double bands = value / band;
        if (!colors.is_signed) return float(bands - std::floor(bands));
        // Rises in one band and falls in the next. A step between bands would give two values that differ only by
        // rounding very different colours.
        const double place = std::abs(std::remainder(bands, 2.0));
        return float(value < 0 ? 0.5 - 0.5 * place : 0.5 + 0.5 * place);
    };
    const auto color_of = [&](const float* value) {
        if (metric == ErrorMetric::absolute)
            return color_on(colors.is_signed && value[0] < 0 ? cold : warm, std::abs(value[0]) / largest);
        Color color{};
        for (int c = 0; c < channels; ++c) color[size_t(c)] = channel_of(value[c]);
        return color;
    };
    Image picture(probe.width, probe.height, 3, 8);
    for (size_t i = 0; i < probe.pixel_count(); ++i) {
        const float* const value = probe.values.data() + i * probe.channels;
        const Color* const special = special_color(value, channels);
        put(picture, i, special ? *special : color_of(value));
    }
    return picture;
}

std::pair<Image, Image> visualize_probes(const Image& one, const Image& other, ProbeColors colors) {
    Image both(one.width, 2 * one.height, one.channels);
    const auto middle = std::copy(one.values.begin(), one.values.end(), both.values.begin());
    std::copy(other.values.begin(), other.values.end(), middle);
    const Image picture = visualize_probe(both, colors);
    Image first(one.width, one.height, picture.channels, 8), second = first;
    const auto half = picture.values.begin() + std::ptrdiff_t(first.values.size());
    std::copy(picture.values.begin(), half, first.values.begin());
    std::copy(half, picture.values.end(), second.values.begin());
    return {first, second};
}

Image visualize_picture(const Image& picture) {
    Image result(picture.width, picture.height, 3, 8);
    const int channels = std::min(picture.channels, 3);
    for (size_t i = 0; i < picture.pixel_count(); ++i) {
        const float* const value = picture.values.data() + i * picture.channels;
        const Color* const special = special_color(value, channels);
        Color color{};
        for (int c = 0; c < 3; ++c) color[size_t(c)] = std::clamp(value[std::min(c, channels - 1)], 0.0f, 1.0f);
        put(result, i, special ? *special : color);
    }
    return result;
}

Image visualize_error(const Image& error, double largest) {
    Image picture(error.width, error.height, 3, 8);
    for (size_t i = 0; i < error.pixel_count(); ++i) {
        const float value = error.values[i];
        put(picture, i,
            std::isnan(value)      ? not_a_number
            : value == not_written ? missing
            : std::isinf(value)    ? nothing
                                   : heat(largest > 0 ? value / largest : 0));
    }
    return picture;
}

}  // namespace relief
