#include "framework/core/image/color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace relief {

double srgb_from_linear(double light) {
    const double size = std::abs(light);
    return std::copysign(size <= 0.0031308 ? 12.92 * size : 1.055 * std::pow(size, 1 / 2.4) - 0.055, light);
}

double linear_from_srgb(double stored) {
    const double size = std::abs(stored);
    return std::copysign(size <= 0.04045 ? size / 12.92 : std::pow((size + 0.055) / 1.055, 2.4), stored);
}

unsigned char srgb8_from_linear(float light) {
    // The light halfway between each stored value and the next, and for each bin the first value to try. Over the
    // square root of light the curve is so even that a bin holds at most one halfway point.
    constexpr int bins = 4096;
    struct Tables {
        std::array<float, 256> halfway{};
        std::array<unsigned char, bins + 1> first{};
    };
    static const Tables tables = [] {
        Tables made;
        for (int i = 0; i < 255; ++i) {
            const double half = linear_from_srgb((i + 0.5) / 255);
            made.halfway[i] = static_cast<float>(half);
            if (made.halfway[i] < half)
                made.halfway[i] = std::nextafter(made.halfway[i], 1.0f);  // the smallest float that rounds up
        }
        made.halfway[255] = std::numeric_limits<float>::infinity();
        for (int i = 0; i <= bins; ++i) {
            // A little below the bin: a square root that is rounded up must not begin too high.
            const float low = static_cast<float>((i - 0.01) * (i - 0.01) / (double(bins) * bins));
            made.first[i] = static_cast<unsigned char>(
                std::upper_bound(made.halfway.begin(), made.halfway.end(), i == 0 ? 0.0f : low) - made.halfway.begin());
        }
        return made;
    }();
    if (!(light > 0)) return 0;
    if (light >= 1) return 255;
    unsigned char stored = tables.first[static_cast<size_t>(std::sqrt(light) * bins)];
    while (light >= tables.halfway[stored]) ++stored;
    return stored;
}

float linear_from_srgb8(unsigned char stored) {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (int i = 0; i < 256; ++i) values[i] = static_cast<float>(linear_from_srgb(i / 255.0));
        return values;
    }();
    return table[stored];
}

}  // namespace relief
