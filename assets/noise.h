// Tiling noise from integer hashes: the same values for the same seed on any machine.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace relief {

/// Chris Wellons' lowbias32 (2018): every input bit changes about half of the output bits.
constexpr uint32_t hash(uint32_t x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}
constexpr uint32_t hash(uint32_t a, uint32_t b, uint32_t c = 0) { return hash(a + hash(b + hash(c + 0x9e3779b9u))); }

/// Returns the top 24 bits as a number in [0, 1), exact in a float.
constexpr float unit(uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

/// A sequence of random numbers for objects that need many (a brick: its size, tone, chips). Calls must have a defined
/// order: use one per statement, or braces. The order of arguments in parentheses is unspecified.
class Dice {
public:
    explicit constexpr Dice(uint32_t seed) : seed_(hash(seed)) {}
    constexpr uint32_t bits() { return hash(seed_, count_++); }
    constexpr float between(float low, float high) { return low + (high - low) * unit(bits()); }
    constexpr bool chance(float probability) { return unit(bits()) < probability; }

private:
    uint32_t seed_, count_ = 0;
};

/// Smoothstep: 0 below `low`, 1 above `high`, cubic between.
inline float ramp(float low, float high, float x) {
    const float t = glm::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

/// Smooth maximum: adds at most width / 4, where the two differ by less than `width`.
inline float smooth_max(float a, float b, float width) {
    const float h = glm::max(width - glm::abs(a - b), 0.0f) / width;
    return glm::max(a, b) + h * h * width / 4;
}

/// Gradient noise (Perlin 2002) with gradients of uneven length, so that no two bumps look alike. Mean 0, standard
/// deviation about 0.3, rarely outside [-1, 1]. `p` is in tiles, any real number. The lattice has `cells` per tile
/// along each axis: the noise repeats with the tile, and its features have a size of about 1 / cells.
float gradient_noise(glm::vec2 p, glm::ivec2 cells, uint32_t seed);

/// The same on a lattice rotated by 27 degrees, with about as many cells.
float turned_noise(glm::vec2 p, int cells, uint32_t seed);

/// Sum of `octaves` octaves: each has twice the cells and half the amplitude of the one before. Scaled to the standard
/// deviation of a single octave.
float fractal_noise(glm::vec2 p, int cells, int octaves, uint32_t seed);

/// Generators use coordinates in texels of a map of this size, for maps of any size.
constexpr float tile = 1024;

/// Noise in these coordinates with features of about `length` texels, a power of two.
inline float noise(glm::vec2 p, int length, uint32_t seed) {
    return gradient_noise(p / tile, glm::ivec2(static_cast<int>(tile) / length), seed);
}
inline float noise(glm::vec2 p, int length, int octaves, uint32_t seed) {
    return fractal_noise(p / tile, static_cast<int>(tile) / length, octaves, seed);
}
/// Grain of two to six texels without a preferred direction; standard deviation about 0.3.
float grain_noise(glm::vec2 p, uint32_t seed);

/// Cellular noise (Worley 1996): one random point per cell.
struct NearestPoint {
    float distance;  ///< in cells
    uint32_t id;     ///< seed bits for further hashing
};
NearestPoint cellular_noise(glm::vec2 p, glm::ivec2 cells, uint32_t seed);

}  // namespace relief
