#include "waves.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/core/base/error.h"
#include "framework/core/image/own_picture.h"
#include "framework/core/image/resample.h"

namespace relief::ocean {
namespace {

constexpr double two_pi = 2 * glm::pi<double>();

struct Spectrum {
    double shortest, longest;  ///< wave numbers, waves per tile
    double course, spread;     ///< mean angle to the z axis, and the largest deviation from it; radians
    double fall;               ///< amplitude falls with this power of the wave number
    unsigned seed;
};
constexpr std::array<Spectrum, 2> spectra = {{{3, 15, 0.5, 0.9, 1.35, 11}, {2, 17, -0.4, 1.5, 1.25, 5}}};

/// Returns a pseudo-random number in [0, 1), the same on every machine (generator of Numerical Recipes).
double next(unsigned& state) {
    state = state * 1664525u + 1013904223u;
    return double(state >> 8) / double(1 << 24);
}

std::array<Wave, waves_a_map> make_waves(const Spectrum& spectrum) {
    std::array<Wave, waves_a_map> waves;
    unsigned state = spectrum.seed;
    double square = 0;
    for (size_t i = 0; i < waves.size();) {
        const double share = (double(i) + next(state)) / double(waves.size()),
                     number = spectrum.shortest * std::pow(spectrum.longest / spectrum.shortest, share),
                     angle = spectrum.course + spectrum.spread * (2 * next(state) - 1), phase = two_pi * next(state);
        const glm::ivec2 k(int(std::lround(number * std::sin(angle))), int(std::lround(number * std::cos(angle))));
        bool is_new = k != glm::ivec2(0);
        for (size_t other = 0; other < i; ++other) is_new &= waves[other].k != k && waves[other].k != -k;
        if (!is_new) continue;
        const double amplitude = std::pow(glm::length(glm::dvec2(k)), -spectrum.fall);
        waves[i++] = {k, amplitude, phase};
        square += amplitude * amplitude / 2;
    }
    for (Wave& wave : waves) wave.amplitude *= 0.25 / std::sqrt(square);
    return waves;
}

}  // namespace

const std::array<Wave, waves_a_map>& waves_of(int map) {
    static const std::array made = {make_waves(spectra[0]), make_waves(spectra[1])};
    return made[size_t(map)];
}

glm::dvec3 slope_moments(int map) {
    glm::dvec3 sum(0);
    for (const Wave& wave : waves_of(map)) {
        const glm::dvec2 steepest = two_pi / tile_metres * wave.amplitude * glm::dvec2(wave.k);
        sum += glm::dvec3(steepest * steepest, steepest.x * steepest.y) / 2.0;
    }
    return sum;
}

namespace {

/// Writes a texel of all images of a map, from the slopes and the height there.
void write_texel(MapImages& images, int x, int row, const glm::dvec3& wave) {
    const double up = 1 / std::sqrt(1 + wave.x * wave.x + wave.y * wave.y);
    const std::array values = {wave.x, wave.y, wave.z}, squares = {wave.x * wave.x, wave.y * wave.y, wave.x * wave.y},
                     normal = {-wave.x * up, -wave.y * up, up};
    for (size_t c = 0; c < 3; ++c) {
        images.waves.pixel(x, row)[c] = float(values[c]);
        images.moments.pixel(x, row)[c] = float(squares[c]);
        images.normals.pixel(x, row)[c] = float(0.5 + 0.5 * normal[c]);
    }
}

MapImages empty_maps() {
    return {Image(map_texels, map_texels, 3), Image(map_texels, map_texels, 3), Image(map_texels, map_texels, 3, 8)};
}

}  // namespace

MapImages make_maps(int map) {
    MapImages images = empty_maps();
    // At texel centres all angles are the phase plus a multiple of half a texel's angle: one table per wave is enough.
    constexpr int halves = 2 * map_texels;
    std::vector<glm::dvec3> sums(size_t(map_texels) * map_texels);
    for (const Wave& wave : waves_of(map)) {
        std::array<glm::dvec2, halves> turn;
        for (int i = 0; i < halves; ++i) {
            const double angle = two_pi * i / halves + wave.phase;
            turn[size_t(i)] = {std::cos(angle), std::sin(angle)};
        }
        const glm::dvec2 steepness = two_pi / tile_metres * wave.amplitude * glm::dvec2(wave.k);
        for (int y = 0; y < map_texels; ++y)
            for (int x = 0; x < map_texels; ++x) {
                const int place = wave.k.x * (2 * x + 1) + wave.k.y * (2 * y + 1);
                const glm::dvec2 at = turn[size_t(place & (halves - 1))];
                sums[size_t(y) * map_texels + size_t(x)] += glm::dvec3(-steepness * at.y, wave.amplitude * at.x);
            }
    }
    for (int y = 0; y < map_texels; ++y)
        for (int x = 0; x < map_texels; ++x)
            write_texel(images, x, map_texels - 1 - y, sums[size_t(y) * map_texels + size_t(x)]);
    return images;
}

Image own_heights(Image picture) {
    if (!is_nearly_grey(picture)) throw Error("shows colours or normals: heights of waves are grey");
    for (float& value : picture.values)
        if (!std::isfinite(value)) value = 0;
    Image heights = resampled(channels_of(picture, 0, 1), map_texels, map_texels);
    const auto [low, high] = std::minmax_element(heights.values.begin(), heights.values.end());
    if (!(*high > *low)) throw Error("has a single height: waves have crests and troughs");
    return heights;
}

Image own_normals(Image picture) {
    if (picture.channels < 3) throw Error("is grey: a normal map has three channels");
    double up = 0;
    for (size_t i = 0; i < picture.pixel_count(); ++i) {
        float& z = picture.values[i * size_t(picture.channels) + 2];
        z = std::isfinite(z) ? std::max(z, 0.55f) : 1;  // a slope of 10 and more has no end
        up += double(z);
    }
    if (up < 0.7 * double(picture.pixel_count())) throw Error("does not point upwards: a normal map is mostly blue");
    Image normals = resampled(channels_of(picture, 0, 3), map_texels, map_texels);
    normals.bits = 8;
    return normals;
}

MapImages maps_of_heights(const Image& heights) {
    const double count = double(heights.values.size());
    double mean = 0, square = 0;
    for (const float height : heights.values) mean += double(height) / count;
    for (const float height : heights.values) square += std::pow(double(height) - mean, 2) / count;
    const double scale = square > 0 ? 0.25 / std::sqrt(square) : 0;
    const auto metres = [&](int x, int row) {
        const auto wrapped = [](int i) { return (i + map_texels) % map_texels; };
        return scale * (double(*heights.pixel(wrapped(x), wrapped(row))) - mean);
    };
    MapImages images = empty_maps();
    constexpr double two_texels = 2 * tile_metres / map_texels;
    for (int row = 0; row < map_texels; ++row)
        for (int x = 0; x < map_texels; ++x)
            write_texel(images, x, row,
                        {(metres(x + 1, row) - metres(x - 1, row)) / two_texels,
                         (metres(x, row - 1) - metres(x, row + 1)) / two_texels, metres(x, row)});
    return images;
}

}  // namespace relief::ocean
