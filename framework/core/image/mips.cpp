#include "framework/core/image/mips.h"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

#include "framework/core/image/color.h"

namespace relief {
namespace {

/// Applies a curve to the colour channels: the first three of 3 or 4, the first of 1 or 2.
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

/// The texels of a row of `from` that one texel of a row of `to` covers, with weights: 2 in an even row, up to 3 in an
/// odd one.
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
                           channels);  // of the source rows that one result row covers
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

std::vector<Image> normal_mip_chain(const Image& normals) {
    Image vectors(normals.width, normals.height, 3);
    const auto for_each_vector = [](Image& image, int channels, const auto& change) {
        for (float* v = image.values.data(); v != image.values.data() + image.values.size(); v += channels) change(v);
    };
    const auto made_unit = [](float* v) {
        const double length = std::sqrt(double(v[0]) * v[0] + double(v[1]) * v[1] + double(v[2]) * v[2]);
        const bool has_direction = length > 1e-6 && std::isfinite(length);
        for (int c = 0; c < 3; ++c) v[c] = has_direction ? float(v[c] / length) : c == 2;
        return has_direction ? length : 0;
    };
    for (size_t i = 0; i < normals.pixel_count(); ++i)
        for (int c = 0; c < 3; ++c)
            vectors.values[i * 3 + size_t(c)] = normals.values[i * size_t(normals.channels) + size_t(c)] * 2 - 1;
    for_each_vector(vectors, 3, made_unit);

    std::vector<Image> chain;
    for (const Image& mean : mip_chain(std::move(vectors), ColorSpace::linear)) {
        Image& level = chain.emplace_back(mean.width, mean.height, 4, normals.bits);
        for (size_t i = 0; i < level.pixel_count(); ++i) {
            float* const texel = level.values.data() + i * 4;
            std::copy_n(mean.values.data() + i * 3, 3, texel);
            // Rounding can make the mean of equal normals slightly longer than 1.
            texel[3] = chain.size() == 1 ? 1 : float(std::min(1.0, made_unit(texel)));
            for (int c = 0; c < 3; ++c) texel[c] = 0.5f * texel[c] + 0.5f;
        }
    }
    return chain;
}

double toksvig_factor(double length, double shininess) {
    return length > 0 ? length / (length + shininess * (1 - length)) : 0;
}

Image gloss_of(const Image& normals, double shininess) {
    Image made(normals.width, normals.height, 1);
    for (int y = 0; y < normals.height; ++y)
        for (int x = 0; x < normals.width; ++x) {
            glm::dvec3 sum(0);
            for (int i = 0; i < 9; ++i) {
                const int u = x + i % 3 - 1 + normals.width, v = y + i / 3 - 1 + normals.height;
                const float* const n = normals.pixel(u % normals.width, v % normals.height);
                sum += glm::normalize(glm::dvec3(n[0], n[1], n[2])) / 9.0;
            }
            *made.pixel(x, y) = float(toksvig_factor(std::min(1.0, glm::length(sum)), shininess));
        }
    return made;
}

}  // namespace relief
