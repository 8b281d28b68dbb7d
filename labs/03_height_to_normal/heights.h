// The heights of lab 03: a function with a known slope, sampled at texels.
#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "framework/core/image/image.h"

namespace relief::heights {

/// A plane wave that tiles. The height is h = 1/2 + the sum of amplitude cos(2 pi (k . uv) + phase), in [0, 1].
struct Wave {
    double amplitude;
    glm::dvec2 k;  ///< whole waves across the map, along u and v
    double phase;
};
constexpr std::array<Wave, 5> waves = {
    {{0.20, {2, 1}, 0.4}, {0.13, {-1, 3}, 2.1}, {0.085, {4, 2}, 4.4}, {0.05, {-3, 5}, 1.3}, {0.03, {7, -4}, 5.2}}};

inline double height(glm::dvec2 uv) {
    double sum = 0.5;
    for (const Wave& wave : waves)
        sum += wave.amplitude * std::cos(2 * glm::pi<double>() * glm::dot(wave.k, uv) + wave.phase);
    return sum;
}

/// Returns dh/du and dh/dv; u and v go from 0 to 1 across the whole map.
inline glm::dvec2 slope(glm::dvec2 uv) {
    glm::dvec2 sum(0);
    for (const Wave& wave : waves)
        sum -= 2 * glm::pi<double>() * wave.amplitude * wave.k *
               std::sin(2 * glm::pi<double>() * glm::dot(wave.k, uv) + wave.phase);
    return sum;
}

/// Returns the uv of a texel's centre. v points up, and row 0 is at the top.
inline glm::dvec2 centre(int x, int y, int size) { return {(x + 0.5) / size, 1 - (y + 0.5) / size}; }

/// Returns the heights at the centres of size x size texels, rounded to `bits` = 8 or 16 bits, or not rounded (32).
inline Image sample(int size, int bits) {
    Image image(size, size, 1, bits);
    const double steps = bits == 32 ? 0 : std::exp2(bits) - 1;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double h = height(centre(x, y, size));
            *image.pixel(x, y) = float(steps > 0 ? std::round(h * steps) / steps : h);
        }
    return image;
}

}  // namespace relief::heights
