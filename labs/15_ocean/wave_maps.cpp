#include "wave_maps.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/library/maps/slope_moments.h"

namespace relief {
namespace {

constexpr double full_turn = 2 * glm::pi<double>();

/// Returns a pseudo-random number in [0, 1), the same on every machine (generator of Numerical Recipes).
double next_random(unsigned& state) {
    state = state * 1664525u + 1013904223u;
    return double(state >> 8) / double(1 << 24);
}

WaveMaps empty_wave_maps(int texels) {
    return {Image(texels, texels, 3), Image(texels, texels, 3), Image(texels, texels, 3, 8)};
}

/// Writes a texel of all maps, from the slopes and the height there.
void write_texel(WaveMaps& maps, int x, int row, const glm::dvec3& wave) {
    const double up = 1 / std::sqrt(1 + wave.x * wave.x + wave.y * wave.y);
    const glm::dvec3 squares = squares_of(glm::dvec2(wave)), normal(-wave.x * up, -wave.y * up, up);
    for (int c = 0; c < 3; ++c) {
        maps.waves.pixel(x, row)[c] = float(wave[c]);
        maps.moments.pixel(x, row)[c] = float(squares[c]);
        maps.normals.pixel(x, row)[c] = float(0.5 + 0.5 * normal[c]);
    }
}

}  // namespace

std::vector<PlaneWave> random_waves(const WaveSpectrum& spectrum, int count) {
    std::vector<PlaneWave> waves;
    unsigned state = spectrum.seed;
    double square = 0;
    while (int(waves.size()) < count) {
        const double share = (double(waves.size()) + next_random(state)) / count,
                     number = spectrum.lowest * std::pow(spectrum.highest / spectrum.lowest, share),
                     angle = spectrum.course + spectrum.spread * (2 * next_random(state) - 1),
                     phase = full_turn * next_random(state);
        const glm::ivec2 k(int(std::lround(number * std::sin(angle))), int(std::lround(number * std::cos(angle))));
        bool is_new = k != glm::ivec2(0);
        for (const PlaneWave& other : waves) is_new &= other.k != k && other.k != -k;
        if (!is_new) continue;
        const double amplitude = std::pow(glm::length(glm::dvec2(k)), -spectrum.fall);
        waves.push_back({k, amplitude, phase});
        square += amplitude * amplitude / 2;
    }
    for (PlaneWave& wave : waves) wave.amplitude *= 0.25 / std::sqrt(square);
    return waves;
}

glm::dvec3 slope_moments(std::span<const PlaneWave> waves, double metres) {
    glm::dvec3 sum(0);
    for (const PlaneWave& wave : waves) {
        const glm::dvec2 steepest = full_turn / metres * wave.amplitude * glm::dvec2(wave.k);
        sum += glm::dvec3(steepest * steepest, steepest.x * steepest.y) / 2.0;
    }
    return sum;
}

WaveMaps wave_maps(std::span<const PlaneWave> waves, int texels, double metres) {
    WaveMaps maps = empty_wave_maps(texels);
    // At texel centres all angles are the phase plus a multiple of half a texel's angle: one table per wave is enough.
    const int halves = 2 * texels;
    std::vector<glm::dvec3> sums(size_t(texels) * size_t(texels));
    for (const PlaneWave& wave : waves) {
        std::vector<glm::dvec2> turn;
        for (int i = 0; i < halves; ++i) {
            const double angle = full_turn * i / halves + wave.phase;
            turn.emplace_back(std::cos(angle), std::sin(angle));
        }
        const glm::dvec2 steepness = full_turn / metres * wave.amplitude * glm::dvec2(wave.k);
        for (int y = 0; y < texels; ++y)
            for (int x = 0; x < texels; ++x) {
                const int place = wave.k.x * (2 * x + 1) + wave.k.y * (2 * y + 1);
                const glm::dvec2 at = turn[size_t(place & (halves - 1))];
                sums[size_t(y) * size_t(texels) + size_t(x)] += glm::dvec3(-steepness * at.y, wave.amplitude * at.x);
            }
    }
    for (int y = 0; y < texels; ++y)
        for (int x = 0; x < texels; ++x)
            write_texel(maps, x, texels - 1 - y, sums[size_t(y) * size_t(texels) + size_t(x)]);
    return maps;
}

WaveMaps wave_maps_of(const Image& heights, double metres) {
    const int texels = heights.width;
    const double count = double(heights.values.size());
    double mean = 0, square = 0;
    for (const float height : heights.values) mean += double(height) / count;
    for (const float height : heights.values) square += std::pow(double(height) - mean, 2) / count;
    const double scale = square > 0 ? 0.25 / std::sqrt(square) : 0;
    const auto height_at = [&](int x, int row) {
        const auto wrapped = [&](int i) { return (i + texels) % texels; };
        return scale * (double(*heights.pixel(wrapped(x), wrapped(row))) - mean);
    };
    WaveMaps maps = empty_wave_maps(texels);
    const double two_texels = 2 * metres / texels;
    for (int row = 0; row < texels; ++row)
        for (int x = 0; x < texels; ++x)
            write_texel(maps, x, row,
                        {(height_at(x + 1, row) - height_at(x - 1, row)) / two_texels,
                         (height_at(x, row - 1) - height_at(x, row + 1)) / two_texels, height_at(x, row)});
    return maps;
}

WaveMeasures measures_of(const std::vector<PlaneWave>& waves, double metres) {
    WaveMeasures result{.moments = slope_moments(waves, metres), .highest = 0, .steepest = 0, .waves = waves};
    for (const PlaneWave& wave : waves) result.highest += std::abs(wave.amplitude);
    return result;
}

WaveMeasures measures_of(const WaveMaps& maps, double metres) {
    WaveMeasures result;
    const size_t texels = maps.waves.pixel_count();
    const double count = double(texels);
    double square = 0;
    for (size_t i = 0; i < texels; ++i) {
        const double height = double(maps.waves.values[3 * i + 2]);
        const double along_u = double(maps.waves.values[3 * i]), along_v = double(maps.waves.values[3 * i + 1]);
        result.highest = std::max(result.highest, std::abs(height)), square += height * height / count;
        result.steepest = std::max(result.steepest, std::hypot(along_u, along_v));
        for (int c = 0; c < 3; ++c) result.moments[c] += double(maps.moments.values[3 * i + size_t(c)]) / count;
    }
    const double slope = result.moments.x + result.moments.y,
                 turns = std::sqrt(slope / std::max(square, 1e-12)) * metres / full_turn;
    result.waves = {{{std::max(1, int(turns + 0.5)), 0}, std::sqrt(2 * square), 0}};
    return result;
}

}  // namespace relief
