// How much of a relief can be left out for a given error in pixels.
#include "framework/staff/reference/budget.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace relief {
namespace {

TEST(Budget, PixelsPerMetreMatchesAFiniteDifference) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> any(-1, 1);
    const glm::dvec2 size(640, 360);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec4 clip(any(random), any(random), any(random), 1.5 + any(random));
        const glm::dvec4 along(any(random), any(random), any(random), any(random));
        const auto pixel = [&](double metres) {
            const glm::dvec4 there = clip + metres * along;
            return glm::dvec2(there) / there.w * size / 2.0;
        };
        const double expected = glm::distance(pixel(1e-5), pixel(-1e-5)) / 2e-5;
        EXPECT_NEAR(pixels_per_metre(clip, along, size), expected, 1e-5 * (1 + expected));
    }
}

TEST(Budget, AMetrePerpendicularToTheViewAtOneMetreSpansARadian) {
    // A camera of 90 degrees: at a distance of w metres the picture is 2 w metres high.
    EXPECT_NEAR(pixels_per_metre({0, 0, 0, 4}, {0, 1, 0, 0}, {100, 100}), 100.0 / 8, 1e-12);
}

TEST(Budget, TwoPixelsTolerateATwentiethOfARelief40PixelsDeep) {
    EXPECT_DOUBLE_EQ(tolerated(2, 10, 4), 0.05);
    EXPECT_EQ(tolerated(2, 10, 0), 1e30);
    EXPECT_EQ(tolerated(2, 0, 4), 1e30);
}

TEST(Budget, ThinsFromBothSidesUpToTheMiddle) {
    EXPECT_EQ(thinned(0.25, 1, 0.25), glm::dvec2(0.5, 0.75));
    EXPECT_EQ(thinned(0.25, 1, 0.375), glm::dvec2(0.625, 0.625));
    EXPECT_EQ(thinned(0.25, 1, 1e30), glm::dvec2(0.625, 0.625));
    EXPECT_EQ(thinned(0.25, 1, 0), glm::dvec2(0.25, 1));
}

TEST(Budget, AllowsTheLevelWhosePolygonErrorReachesIt) {
    const std::array errors{0.125f, 0.25f, 0.25f, 0.75f};
    EXPECT_EQ(coarsest_level(errors, 0.0625), 0);
    EXPECT_EQ(coarsest_level(errors, 0.125), 0);
    EXPECT_EQ(coarsest_level(errors, 0.1875), 0.5);
    EXPECT_EQ(coarsest_level(errors, 0.25), 2);
    EXPECT_EQ(coarsest_level(errors, 0.5), 2.5);
    EXPECT_EQ(coarsest_level(errors, 0.75), 3);
    EXPECT_EQ(coarsest_level(errors, 5), 3);
}

TEST(Budget, DoublingItFadesBumpsOneLevelSooner) {
    EXPECT_EQ(bumps_left(5, 7, 1), 1);
    EXPECT_EQ(bumps_left(6.5, 7, 1), 0.5);
    EXPECT_EQ(bumps_left(5.5, 7, 2), 0.5);
    EXPECT_EQ(bumps_left(5.5, 7, 4), 0);
}

}  // namespace
}  // namespace relief
