// Maps of slopes and of their squares, compared with a sum of waves.
#include "framework/library/maps/slope_moments.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/core/image/mips.h"

namespace relief {
namespace {

constexpr int slope_texels = 64;

/// Returns the slope of two waves that tile, at the centre of a texel; row 0 is the top.
glm::dvec2 slope_of_two_waves(int x, int row) {
    const glm::dvec2 uv((x + 0.5) / slope_texels, 1 - (row + 0.5) / slope_texels);
    const double turn = 2 * glm::pi<double>();
    return 0.6 * glm::dvec2(3, 1) * std::cos(turn * (3 * uv.x + uv.y)) +
           0.2 * glm::dvec2(-2, 5) * std::cos(turn * (5 * uv.y - 2 * uv.x) + 1);
}

Image normals_of_two_waves() {
    Image normals(slope_texels, slope_texels, 3);
    for (int row = 0; row < slope_texels; ++row)
        for (int x = 0; x < slope_texels; ++x) {
            const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope_of_two_waves(x, row), 1));
            for (int c = 0; c < 3; ++c) normals.pixel(x, row)[c] = float(0.5 + 0.5 * normal[c]);
        }
    return normals;
}

TEST(SlopeMoments, OfALevelAreTheMeansOverItsFootprint) {
    const SlopeMaps maps = slope_maps(normals_of_two_waves());
    const std::vector<Image> slopes = mip_chain(maps.slopes, ColorSpace::linear),
                             squares = mip_chain(maps.squares, ColorSpace::linear);
    ASSERT_EQ(slopes.size(), 7u);
    ASSERT_EQ(squares.size(), 7u);
    for (size_t level = 0; level < slopes.size(); ++level) {
        const int side = 1 << level;
        for (int row = 0; row < slope_texels; row += side)
            for (int x = 0; x < slope_texels; x += side) {
                std::array<double, 5> mean{};  // of the slopes, their squares, and their product
                for (int i = 0; i < side * side; ++i) {
                    const glm::dvec2 slope = slope_of_two_waves(x + i % side, row + i / side);
                    const std::array values = {slope.x, slope.y, slope.x * slope.x, slope.y * slope.y,
                                               slope.x * slope.y};
                    for (size_t k = 0; k < 5; ++k) mean[k] += values[k] / (side * side);
                }
                const float* const first = slopes[level].pixel(x / side, row / side);
                const float* const second = squares[level].pixel(x / side, row / side);
                for (size_t k = 0; k < 5; ++k)
                    EXPECT_NEAR(double(k < 2 ? first[k] : second[k - 2]), mean[k], 2e-5) << level << " " << k;
            }
    }
}

TEST(SlopeMoments, OfAWholeTileAreThoseOfItsWaves) {
    // The mean of a squared cosine is 1/2, and different waves that tile are uncorrelated.
    const Image squares = mip_chain(slope_maps(normals_of_two_waves()).squares, ColorSpace::linear).back();
    EXPECT_NEAR(double(squares.values[0]), (0.36 * 9 + 0.04 * 4) / 2, 1e-5);
    EXPECT_NEAR(double(squares.values[1]), (0.36 * 1 + 0.04 * 25) / 2, 1e-5);
    EXPECT_NEAR(double(squares.values[2]), (0.36 * 3 - 0.04 * 10) / 2, 1e-5);
}

TEST(SlopeMoments, ANormalWithoutHeightHasAFiniteSlope) {
    Image normals(1, 1, 3);
    normals.values = {1, 0.5f, 0.5f};  // along u
    const SlopeMaps maps = slope_maps(normals);
    EXPECT_NEAR(double(maps.slopes.values[0]), -100, 1e-3);
    EXPECT_NEAR(double(maps.squares.values[0]), 1e4, 0.1);
}

}  // namespace
}  // namespace relief
