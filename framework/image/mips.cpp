#include "framework/image/mips.h"

#include <algorithm>
#include <cmath>

#include "framework/image/color.h"

namespace relief {
namespace {

/// Applies a curve to what is colour: of 3 or 4 channels the first three, of 1 or 2 the first.
template <class Curve>
void apply_to_color(Image& image, Curve curve) {
    const int colors = image.channels >= 3 ? 3 : 1;
    for (float* pixel = image.values.data(); pixel != image.values.data() + image.values.size();
         pixel += image.channels)
        for (int c = 0; c < colors; ++c) pixel[c] = curve(pixel[c]);
}

float light_of(float stored, int bits) {
    if (bits == 8) return linear_from_srgb8(static_cast<unsigned char>(stored * 255 + 0.5f));
    return static_cast<float>(linear_from_srgb(stored));
}

float stored_of(float light, int bits) {
    if (bits == 8) return static_cast<float>(srgb8_from_linear(light)) / 255;
    return static_cast<float>(srgb_from_linear(light));
}

/// Which texels of a row of `from` one texel of a row of `to` covers, and how much of each: 2, or 3 when odd.
struct Cover {
    int first, count;
    float weight[3];
};

std::vector<Cover> covers(int from, int to) {
    std::vector<Cover> result(to);
    for (int i = 0; i < to; ++i) {
        const double begin = static_cast<double>(i) * from / to, end = static_cast<double>(i + 1) * from / to;
        const int first = static_cast<int>(begin), last = std::min(from, static_cast<int>(std::ceil(end)));
        Cover& cover = result[i] = {first, last - first, {}};
        for (int k = 0; k < cover.count; ++k) {
            const double inside = std::min<double>(end, first + k + 1) - std::max<double>(begin, first + k);
            cover.weight[k] = static_cast<float>(inside / (end - begin));
        }
    }
    return result;
}

Image half(const Image& image) {
    Image result(std::max(1, image.width / 2), std::max(1, image.height / 2), image.channels, image.bits);
    const auto columns = covers(image.width, result.width), rows = covers(image.height, result.height);
    const size_t channels = static_cast<size_t>(image.channels);
    std::vector<float> sum(static_cast<size_t>(image.width) *
                           channels);  // of the rows that one row of the result covers
    for (int y = 0; y < result.height; ++y) {
        std::fill(sum.begin(), sum.end(), 0.0f);
        for (int j = 0; j < rows[y].count; ++j) {
            const float* const source = image.pixel(0, rows[y].first + j);
            for (size_t i = 0; i < sum.size(); ++i) sum[i] += rows[y].weight[j] * source[i];
        }
        float* texel = result.pixel(0, y);
        for (const Cover& cover : columns) {
            const float* source = sum.data() + static_cast<size_t>(cover.first) * channels;
            for (int i = 0; i < cover.count; ++i)
                for (size_t c = 0; c < channels; ++c) texel[c] += cover.weight[i] * *source++;
            texel += channels;
        }
    }
    return result;
}

}  // namespace

std::vector<Image> mip_chain(Image image, ColorSpace space) {
    std::vector<Image> chain;
    chain.push_back(std::move(image));
    Image level = chain.front();
    const int bits = level.bits;
    if (space == ColorSpace::srgb) apply_to_color(level, [=](float v) { return light_of(v, bits); });
    while (level.width > 1 || level.height > 1) {
        level = half(level);
        chain.push_back(level);
        if (space == ColorSpace::srgb) apply_to_color(chain.back(), [=](float v) { return stored_of(v, bits); });
    }
    return chain;
}

}  // namespace relief
