#include "framework/library/maps/resample.h"

#include <algorithm>
#include <cmath>

namespace relief {
namespace {

/// The weights of a row's texels, from texel `first` on, in one texel of the result. The row repeats.
struct Tent {
    int first;
    std::vector<float> weights;  ///< their sum is 1
};

std::vector<Tent> tents(int from, int to) {
    const double scale = double(from) / to, radius = std::max(1.0, scale);
    std::vector<Tent> result(static_cast<size_t>(to));
    for (int i = 0; i < to; ++i) {
        const double middle = (i + 0.5) * scale - 0.5;
        Tent& tent = result[size_t(i)];
        tent.first = int(std::ceil(middle - radius));
        double sum = 0;
        for (int k = tent.first; k <= int(std::floor(middle + radius)); ++k) {
            tent.weights.push_back(float(1 - std::abs(k - middle) / radius));
            sum += double(tent.weights.back());
        }
        for (float& weight : tent.weights) weight = float(double(weight) / sum);
    }
    return result;
}

int wrapped(int i, int count) { return ((i % count) + count) % count; }

/// Resamples each row to `width` texels, and transposes the image.
Image turned_rows(const Image& image, int width) {
    Image result(image.height, width, image.channels);
    const std::vector<Tent> columns = tents(image.width, width);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < width; ++x) {
            const Tent& tent = columns[size_t(x)];
            float* const sum = result.pixel(y, x);
            for (size_t k = 0; k < tent.weights.size(); ++k) {
                const float* const texel = image.pixel(wrapped(tent.first + int(k), image.width), y);
                for (int c = 0; c < image.channels; ++c) sum[c] += tent.weights[k] * texel[c];
            }
        }
    return result;
}

}  // namespace

Image resampled(const Image& image, int width, int height) { return turned_rows(turned_rows(image, width), height); }

}  // namespace relief
