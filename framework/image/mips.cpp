#include "framework/image/mips.h"

#include <algorithm>
#include <cmath>

#include "framework/image/color.h"

namespace relief {
namespace {

bool is_color(int channel, int channels) { return channels >= 3 ? channel < 3 : channel < 1; }

template <class Curve>
void apply_to_color(Image& image, Curve curve) {
    for (size_t i = 0; i < image.values.size(); ++i)
        if (is_color(static_cast<int>(i % image.channels), image.channels))
            image.values[i] = curve(image.values[i]);
}

float light_of(float stored, int bits) {
    if (bits == 8) return linear_from_srgb8(static_cast<unsigned char>(std::lround(stored * 255)));
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
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            float* const texel = result.pixel(x, y);
            for (int j = 0; j < rows[y].count; ++j)
                for (int i = 0; i < columns[x].count; ++i) {
                    const float weight = rows[y].weight[j] * columns[x].weight[i];
                    const float* const source = image.pixel(columns[x].first + i, rows[y].first + j);
                    for (int c = 0; c < image.channels; ++c) texel[c] += weight * source[c];
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
        if (space == ColorSpace::srgb)
            apply_to_color(chain.back(), [=](float v) { return stored_of(v, bits); });
    }
    return chain;
}

}  // namespace relief
