// Noise that tiles, from integer hashes: the same numbers for the same seed, on any machine.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace relief {

/// Chris Wellons' lowbias32 (2018): every bit of the input changes about half of the bits of the result.
constexpr uint32_t hash(uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
constexpr uint32_t hash(uint32_t a, uint32_t b, uint32_t c = 0) { return hash(a + hash(b + hash(c + 0x9e3779b9u))); }

/// The top 24 bits, as a number in [0, 1): exact in a float.
constexpr float unit(uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

/// Numbers one after the other, where one thing needs many (a brick: its size, tone, chips). The order of throws must
/// not be left to the compiler, as it is among arguments in parentheses: one to a statement, or in braces.
class Dice {
public:
    explicit constexpr Dice(uint32_t seed) : seed_(hash(seed)) {}
    constexpr uint32_t bits() { return hash(seed_, count_++); }
    constexpr float between(float low, float high) { return low + (high - low) * unit(bits()); }
    constexpr bool chance(float probability) { return unit(bits()) < probability; }

private:
    uint32_t seed_, count_ = 0;
};

/// 0 below `low`, 1 above `high`, smooth (cubic) between.
inline float ramp(float low, float high, float x) {
    const float t = glm::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// The larger of two, rounded where they differ by less than `width`: by width / 4 at most.
inline float smooth_max(float a, float b, float width) {
    const float h = glm::max(width - glm::abs(a - b), 0.0f) / width;
    return glm::max(a, b) + h * h * width / 4;
}

/// Gradient noise (Perlin 2002, with gradients of uneven length so that no bump looks like the next): mean 0,
/// standard deviation about 0.3, hardly ever beyond 1 in size. `p` is in tiles, any real; the lattice has
/// `cells` to the tile along each axis, so the noise repeats with the tile and varies over about 1 / cells.
float gradient_noise(glm::vec2 p, glm::ivec2 cells, uint32_t seed);

/// The same on a lattice turned by 27 degrees, with about as many cells.
float turned_noise(glm::vec2 p, int cells, uint32_t seed);

/// `octaves` of it: each with twice the cells and half the size of the one before, in all as large as one.
float fractal_noise(glm::vec2 p, int cells, int octaves, uint32_t seed);

/// A generator lays things out in texels of a map of this size, whatever the size of the map it makes.
constexpr float tile = 1024;

/// Noise over such a layout that varies over about `length` texels, a power of two.
inline float noise(glm::vec2 p, int length, uint32_t seed) {
    return gradient_noise(p / tile, glm::ivec2(static_cast<int>(tile) / length), seed);
}
inline float noise(glm::vec2 p, int length, int octaves, uint32_t seed) {
    return fractal_noise(p / tile, static_cast<int>(tile) / length, octaves, seed);
}
/// Grain of two to six texels, without a favourite direction; standard deviation about 0.3.
float grain_noise(glm::vec2 p, uint32_t seed);

/// Cellular noise (Worley 1996): one random point to a cell.
struct NearestPoint {
    float distance;  ///< in cells
    uint32_t id;     ///< bits to hash on
};
NearestPoint cellular_noise(glm::vec2 p, glm::ivec2 cells, uint32_t seed);

}  // namespace relief
