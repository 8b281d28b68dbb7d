// Error bounds of a height map's levels.
#include "labs/17_time_and_error/levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "framework/core/image/mips.h"
#include "framework/library/maps/test_maps.h"
#include "framework/staff/reference/height_field.h"

namespace relief {
namespace {

TEST(HeightLevels, HaveZeroErrorOnAFlatMap) {
    for (const auto& errors : {level_errors(make_height_map(HeightMap::plateau, 16), 1),
                               piece_errors(make_height_map(HeightMap::plateau, 16), 1)}) {
        EXPECT_EQ(errors.size(), 5u);
        for (const float error : errors) EXPECT_EQ(error, 0);
    }
}

TEST(HeightLevels, HaveTheComputedErrorOnASinglePost) {
    Image image(4, 4, 1);
    *image.pixel(1, 1) = 1;
    const auto errors = level_errors(image, 10);
    // Level 0 against its chords: second differences are -2 along both axes, the twist is 1.
    EXPECT_NEAR(errors[0], std::sqrt(8.0) / 4 + 1.0 / 8, 1e-6);
    // Level 1 is 1/4 in the texel that covers the post. The post's centre is a quarter of this texel from its middle.
    // There, level 1 interpolates to 1/4 (3/4)², an error of 55/64. Its second differences are -1/2, its twist is 1/4.
    EXPECT_NEAR(errors[1], 55.0 / 64 + std::sqrt(0.5) / 4 + 0.25 / 8, 1e-6);
    // The mean is 1/16.
    EXPECT_NEAR(errors[2], std::max(15.0 / 16, double(errors[1])), 1e-6);
}

TEST(HeightLevels, EndAtTheFirstLevelBeyondTheTolerance) {
    const Image image = make_height_map(HeightMap::fbm, 64);
    const auto all = level_errors(image, 10), some = level_errors(image, 0.3f);
    ASSERT_LT(some.size(), all.size());
    EXPECT_TRUE(std::equal(some.begin(), some.end(), all.begin()));
    EXPECT_LT(some.back(), 0.3f);
    EXPECT_GE(all[some.size()], 0.3f);
    EXPECT_EQ(level_errors(image, 0).size(), 1u) << "there is always one";
    EXPECT_EQ(piece_errors(image, 0).size(), 1u);
}

TEST(HeightLevels, BoundTheErrorOfAMarch) {
    // For two samples at a distance of one texel of the level: the chord between its heights against the surface
    // itself.
    for (const HeightMap map : {HeightMap::smooth, HeightMap::fbm, HeightMap::stones}) {
        const Image image = make_height_map(map, 128);
        const HeightField field(image, true);
        const std::vector<Image> levels = mip_chain(image, ColorSpace::linear);
        const auto errors = level_errors(image, 10);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(0, 128), turn(0, 6.2831853);
        for (size_t k = 0; k < levels.size(); ++k) {
            const HeightField level(levels[k], true);
            double largest = 0;
            for (int i = 0; i < 3000; ++i) {
                const glm::dvec2 from(place(random), place(random));
                const double angle = turn(random), texel = std::exp2(double(k));
                const glm::dvec2 to = from + texel * glm::dvec2(std::cos(angle), std::sin(angle));
                const double a = level.height(from / texel), b = level.height(to / texel);
                for (int j = 0; j <= 8; ++j)
                    largest = std::max(
                        largest, std::abs(field.height(from + (to - from) * (j / 8.0)) - (a + (b - a) * (j / 8.0))));
            }
            EXPECT_LE(largest, double(errors[k]) + 1e-6) << int(map) << " level " << k;
            EXPECT_GE(largest, 0.25 * double(errors[k])) << int(map) << " level " << k << ": a bound that says nothing";
        }
    }
}

TEST(HeightLevels, BoundTheErrorOfTriangles) {
    const Image image = make_height_map(HeightMap::smooth, 128);
    const HeightField field(image, true);
    const auto errors = piece_errors(image, 10);
    std::mt19937 random(6);
    std::uniform_real_distribution<double> share(0, 1);
    for (size_t k = 0; k < errors.size(); ++k) {
        const int side = 1 << k;
        double largest = 0;
        for (int i = 0; i < 4000; ++i) {
            const glm::dvec2 low(double(random() % (128u >> k)) * side, double(random() % (128u >> k)) * side);
            glm::dvec2 at(share(random), share(random));
            const auto h = [&](double x, double y) { return field.height(low + glm::dvec2(x, y) * double(side)); };
            // The lower triangle of one diagonal, then that of the other.
            if (at.x + at.y > 1) at = 1.0 - at;
            largest = std::max(
                largest, std::abs(h(at.x, at.y) - (h(0, 0) + at.x * (h(1, 0) - h(0, 0)) + at.y * (h(0, 1) - h(0, 0)))));
            if (at.y > at.x) std::swap(at.x, at.y);
            largest = std::max(
                largest, std::abs(h(at.x, at.y) - (h(0, 0) + at.x * (h(1, 0) - h(0, 0)) + at.y * (h(1, 1) - h(1, 0)))));
        }
        EXPECT_LE(largest, double(errors[k]) + 1e-6) << "pieces of " << side;
    }
}

}  // namespace
}  // namespace relief
