#include "framework/image/color.h"

#include <algorithm>
#include <array>
#include <cmath>

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
    // The light half way between each stored value and the next, so that the answer is a search.
    static const std::array<float, 255> halfway = [] {
        std::array<float, 255> table{};
        for (int i = 0; i < 255; ++i) table[i] = static_cast<float>(linear_from_srgb((i + 0.5) / 255));
        return table;
    }();
    return static_cast<unsigned char>(std::upper_bound(halfway.begin(), halfway.end(), light) -
                                      halfway.begin());
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
