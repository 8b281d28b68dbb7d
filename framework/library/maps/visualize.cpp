#include "framework/library/maps/visualize.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

double usual_size(const Image& probe, int first_channel, int channels) {
    std::vector<double> sizes;
    for (size_t i = 0; i < probe.pixel_count(); ++i)
        for (int c = first_channel; c < std::min(first_channel + channels, probe.channels); ++c) {
            const float value = probe.values[i * size_t(probe.channels) + size_t(c)];
            if (std::isfinite(value) && value != 0) sizes.push_back(std::abs(value));
        }
    if (sizes.empty()) return 1;
    const auto middle = sizes.begin() + std::ptrdiff_t(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

namespace {

/// The tone curve of one channel, and the values that it maps to black and to full brightness.
class Channel {
public:
    Channel(const Image& probe, size_t channel, double usual, bool is_signed) : is_signed_(is_signed), usual_(usual) {
        for (size_t i = channel; i < probe.values.size(); i += size_t(probe.channels)) {
            if (!std::isfinite(probe.values[i])) continue;
            lowest_ = std::min<double>(lowest_, probe.values[i]),
            highest_ = std::max<double>(highest_, probe.values[i]);
        }
        if (lowest_ > highest_) lowest_ = highest_ = 0;
        largest_ = std::max(std::abs(lowest_), std::abs(highest_));
    }
    double largest() const { return largest_; }
    /// Widens the range of a constant channel. `rounding`: smaller values are rounding errors of the other channels.
    void finish(double rounding) {
        if (is_signed_) {
            highest_ = std::max(largest_, rounding), lowest_ = -highest_;
        } else if (highest_ - lowest_ < std::max(1e-3 * largest_, rounding)) {
            lowest_ = std::min(lowest_, 0.0), highest_ = std::max(highest_, rounding);
        }
        largest_ = std::max(largest_, rounding), usual_ = std::max(usual_, rounding), scale_ = largest_ / usual_;
    }
    /// Returns the curve's result in [-1, 1], with the sign of the value.
    double curve(double value) const {
        const double x = std::abs(value) / usual_;
        return scale_ > 0 ? std::copysign(x * (1 + x / (scale_ * scale_)) / (1 + x), value) : 0;
    }
    float shade(double value) const {
        const double black = curve(lowest_), white = curve(highest_);
        if (!(white > black)) return is_signed_ ? 0.5f : 0.0f;  // the channel is 0 everywhere
        return float(std::clamp((curve(value) - black) / (white - black), 0.0, 1.0));
    }

private:
    bool is_signed_;
    double usual_, scale_ = 0;
    double lowest_ = std::numeric_limits<double>::max(), highest_ = std::numeric_limits<double>::lowest(), largest_ = 0;
};

/// Returns the picture of a probe. The usual sizes are those of `exposed`, an image of the same quantity.
Image colored(const Image& probe, ProbeColors colors, const Image& exposed) {
    const int channels = std::min(probe.channels, 3);
    std::vector<Channel> scales;
    double largest = 0;
    for (int c = 0; c < channels; ++c) {
        scales.emplace_back(probe, size_t(c), usual_size(exposed, c, 1), colors.is_signed);
        largest = std::max(largest, scales.back().largest());
    }
    for (Channel& scale : scales) scale.finish(1e-5 * largest);

    const auto color_of = [&](const float* value) {
        if (colors.error == ErrorMetric::absolute)
            return color_on(colors.is_signed && value[0] < 0 ? cold : warm, std::abs(scales[0].curve(value[0])));
        Color color{};
        for (int c = 0; c < channels; ++c)
            color[size_t(c)] = colors.error == ErrorMetric::angle ? std::clamp(0.5f * value[c] + 0.5f, 0.0f, 1.0f)
                                                                  : scales[size_t(c)].shade(value[c]);
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

}  // namespace

Image visualize_probe(const Image& probe, ProbeColors colors) { return colored(probe, colors, probe); }

std::pair<Image, Image> visualize_probes(const Image& drawn, const Image& expected, ProbeColors colors) {
    Image both(drawn.width, 2 * drawn.height, drawn.channels);
    const auto middle = std::copy(drawn.values.begin(), drawn.values.end(), both.values.begin());
    std::copy(expected.values.begin(), expected.values.end(), middle);
    const Image picture = colored(both, colors, expected);
    Image first(drawn.width, drawn.height, picture.channels, 8), second = first;
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
