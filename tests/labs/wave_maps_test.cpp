// Maps of waves, compared with their cosines.
#include "labs/15_ocean/wave_maps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace relief {
namespace {

constexpr int wave_texels = 64;
constexpr double tile_width = 5;
const WaveSpectrum of_waves{.lowest = 2, .highest = 9, .course = 0.3, .spread = 1.2, .fall = 1.3, .seed = 7};

/// Returns the slopes along u and v, and the height, at the centre of a texel.
glm::dvec3 exact_waves_at(const std::vector<PlaneWave>& waves, int x, int row) {
    const glm::dvec2 uv((x + 0.5) / wave_texels, 1 - (row + 0.5) / wave_texels);
    glm::dvec3 sum(0);
    for (const PlaneWave& wave : waves) {
        const glm::dvec2 number = 2 * glm::pi<double>() * glm::dvec2(wave.k);
        const double angle = glm::dot(number, uv) + wave.phase;
        sum += wave.amplitude * glm::dvec3(-number / tile_width * std::sin(angle), std::cos(angle));
    }
    return sum;
}

TEST(Waves, DifferAndHaveASignificantHeightOfOneMetre) {
    const std::vector<PlaneWave> waves = random_waves(of_waves, 12);
    ASSERT_EQ(waves.size(), 12u);
    double square = 0;
    for (size_t i = 0; i < waves.size(); ++i) {
        square += waves[i].amplitude * waves[i].amplitude / 2;
        EXPECT_GE(glm::length(glm::dvec2(waves[i].k)), 2 - 0.8) << "rounded to whole numbers";
        EXPECT_LE(glm::length(glm::dvec2(waves[i].k)), 9 + 0.8);
        for (size_t other = 0; other < i; ++other)
            EXPECT_TRUE(waves[i].k != waves[other].k && waves[i].k != -waves[other].k);
    }
    EXPECT_NEAR(4 * std::sqrt(square), 1, 1e-12);
    EXPECT_NE(
        random_waves({.lowest = 2, .highest = 9, .course = 0.3, .spread = 1.2, .fall = 1.3, .seed = 8}, 12)[0].phase,
        waves[0].phase);
}

TEST(Waves, MapsMatchTheCosines) {
    const std::vector<PlaneWave> waves = random_waves(of_waves, 12);
    const WaveMaps maps = wave_maps(waves, wave_texels, tile_width);
    glm::dvec3 moments(0);
    for (int row = 0; row < wave_texels; ++row)
        for (int x = 0; x < wave_texels; ++x) {
            const glm::dvec3 exact = exact_waves_at(waves, x, row);
            const glm::dvec3 normal = glm::normalize(glm::dvec3(-glm::dvec2(exact), 1));
            const glm::dvec3 squares(exact.x * exact.x, exact.y * exact.y, exact.x * exact.y);
            for (int c = 0; c < 3; ++c) {
                ASSERT_NEAR(maps.waves.pixel(x, row)[c], exact[c], 1e-6);
                ASSERT_NEAR(maps.moments.pixel(x, row)[c], squares[c], 1e-6);
                ASSERT_NEAR(maps.normals.pixel(x, row)[c], 0.5 + 0.5 * normal[c], 1e-6);
            }
            moments += squares / double(wave_texels * wave_texels);
        }
    // Different waves with whole numbers of periods are orthogonal. Half of the square of each one remains.
    EXPECT_LT(glm::distance(moments, slope_moments(waves, tile_width)), 1e-9);
}

TEST(Waves, MapsOfTheirHeightsHaveTheSameSlopes) {
    // A central difference of a wave of 64 / 9 texels is too flat by the sinc of 2 pi 9 / 64: by 13 %.
    const std::vector<PlaneWave> waves = random_waves(of_waves, 12);
    const WaveMaps maps = wave_maps(waves, wave_texels, tile_width);
    Image heights(wave_texels, wave_texels, 1);
    for (size_t i = 0; i < heights.values.size(); ++i) heights.values[i] = 0.4f + 0.1f * maps.waves.values[3 * i + 2];
    const WaveMaps made = wave_maps_of(heights, tile_width);
    double off = 0, all = 0;
    for (size_t i = 0; i < heights.values.size(); ++i) {
        EXPECT_NEAR(made.waves.values[3 * i + 2], maps.waves.values[3 * i + 2], 1e-5) << "shifted and scaled";
        for (size_t c = 0; c < 2; ++c) {
            off += std::pow(double(made.waves.values[3 * i + c] - maps.waves.values[3 * i + c]), 2);
            all += std::pow(double(maps.waves.values[3 * i + c]), 2);
        }
    }
    EXPECT_LT(std::sqrt(off / all), 0.13);
    for (const float value : wave_maps_of(Image(8, 8, 1), tile_width).waves.values) EXPECT_EQ(value, 0) << "no waves";
}

TEST(Waves, TheMeasuresOfMapsAreThoseOfTheirCosines) {
    const std::vector<PlaneWave> waves = random_waves(of_waves, 12);
    const WaveMaps maps = wave_maps(waves, wave_texels, tile_width);
    const WaveMeasures exact = measures_of(waves, tile_width), found = measures_of(maps, tile_width);
    EXPECT_LT(glm::distance(exact.moments, found.moments), 1e-6);
    EXPECT_GE(exact.highest, found.highest);
    for (size_t i = 2; i < maps.waves.values.size(); i += 3) ASSERT_LE(std::abs(maps.waves.values[i]), found.highest);
    // One cosine has the mean square of all.
    ASSERT_EQ(found.waves.size(), 1u);
    EXPECT_NEAR(4 * std::sqrt(found.waves[0].amplitude * found.waves[0].amplitude / 2), 1, 1e-6);
    const glm::dvec3 slopes = slope_moments(found.waves, tile_width);
    const double half_a_wave = glm::pi<double>() / tile_width * std::sqrt(1.0 / 16);
    EXPECT_NEAR(std::sqrt(slopes.x + slopes.y), std::sqrt(exact.moments.x + exact.moments.y), half_a_wave)
        << "the number of waves is whole";
}

}  // namespace
}  // namespace relief
