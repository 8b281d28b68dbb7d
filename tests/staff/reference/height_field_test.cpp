// The exact hit: against closed forms, against brute force, and in cases where searches fail.
#include "framework/staff/reference/height_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "framework/core/base/error.h"
#include "tests/support.h"

namespace relief {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Makes a map from a function of column and row. Row 0 is the lowest here, since v grows up.
template <class Height>
HeightField field(int columns, int rows, bool wraps, Height height) {
    Image image(columns, rows, 1);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            *image.pixel(column, rows - 1 - row) = float(height(column, row));
    return {image, wraps};
}

HeightField random_field(unsigned seed, int columns, int rows, bool wraps) {
    std::mt19937 random(seed);
    return field(columns, rows, wraps, [&](int, int) { return std::uniform_real_distribution<>(0, 1)(random); });
}

/// Returns a ray that enters at height 1 over `texel` and reaches height 0 after `along` texels.
Ray down(glm::dvec2 texel, glm::dvec2 along) { return {{texel, 1}, {along, -1}}; }

/// Finds the first hit with steps of 1/400 texel and 60 bisections. Slow, and independent of the cells.
double first_hit_by_force(const HeightField& field, const Ray& ray, double bend = 0, double t_end = 1) {
    const auto gap = [&](double t) { return ray.at(t).z + bend * t * t - field.height(glm::dvec2(ray.at(t))); };
    if (gap(0) <= 0) return 0;
    const double step = 1 / (400 * std::max(1.0, glm::length(glm::dvec2(ray.direction))));
    double t = 0;
    while (gap(t + step) > 0)
        if ((t += step) > t_end) return infinity;
    double low = t, high = t + step;
    for (int i = 0; i < 60; ++i) (gap((low + high) / 2) > 0 ? low : high) = (low + high) / 2;
    return high;
}

TEST(HeightField, ABentRayHitsLikeBruteForceOrLeavesThroughTheTop) {
    const HeightField rough = random_field(3, 16, 16, true);
    std::mt19937 random(4);
    std::uniform_real_distribution<> share(0, 1);
    int hits = 0, misses = 0;
    for (int i = 0; i < 400; ++i) {
        const double turn = 2 * M_PI * share(random), reach = 20 * share(random), bend = share(random);
        const Ray ray =
            down({16 * share(random), 16 * share(random)}, {reach * std::cos(turn), reach * std::sin(turn)});
        const double t_end = 1 / bend;  // back at height 1
        const double forced = first_hit_by_force(rough, ray, bend, std::min(t_end, 50.0));
        const auto hit = rough.first_hit(ray, std::min(t_end, 50.0), bend);
        ASSERT_EQ(hit.has_value(), std::isfinite(forced)) << i;
        if (hit) {
            EXPECT_NEAR(hit->t, forced, 1e-9) << i;
        }
        ++(hit ? hits : misses);
    }
    EXPECT_GT(hits, 50);
    EXPECT_GT(misses, 20);
    EXPECT_FALSE(rough.first_hit(down({1, 1}, {1, 1}), infinity, 0.5)) << "a bent ray wants an end";
}

TEST(HeightField, GoesThroughTheTexelCentresAndIsBilinearBetween) {
    const HeightField steps = field(2, 2, false, [](int x, int y) { return x + 2 * y; });
    EXPECT_EQ(steps.height({0.5, 0.5}), 0);
    EXPECT_EQ(steps.height({1.5, 0.5}), 1);
    EXPECT_EQ(steps.height({0.5, 1.5}), 2) << "v grows upwards";
    EXPECT_EQ(steps.height({1, 1}), 1.5);
    EXPECT_EQ(steps.slope({1, 1}), glm::dvec2(1, 2));
    EXPECT_EQ(steps.height({-7, -7}), 0) << "clamped";
    EXPECT_EQ(steps.height({90, 90}), 3);
    EXPECT_EQ(steps.slope({90, 90}), glm::dvec2(0));
    const HeightField saddle = field(2, 2, false, [](int x, int y) { return x == y; });
    EXPECT_EQ(saddle.height({1, 1}), 0.5);
    EXPECT_EQ(saddle.slope({1, 0.5}), glm::dvec2(-1, 0));
}

TEST(HeightField, RepeatsWhenItWraps) {
    const HeightField tile = random_field(1, 5, 3, true);
    for (const glm::dvec2 place : {glm::dvec2(0.1, 0.2), glm::dvec2(4.9, 2.8), glm::dvec2(2.3, 1.7)})
        for (const glm::dvec2 shift : {glm::dvec2(5, 0), glm::dvec2(0, -3), glm::dvec2(-50, 30)})
            EXPECT_NEAR(tile.height(place + shift), tile.height(place), 1e-14);
}

TEST(HeightField, RefusesAnEmptyMapAndNanHeights) {
    EXPECT_THROW(HeightField(Image(), true), Error);
    EXPECT_THROW(HeightField(Image(2, 2, 3), true), Error);
    Image holed(3, 2, 1);
    *holed.pixel(2, 1) = std::nanf("");
    EXPECT_TRUE(contains(message_of([&] { HeightField(holed, true); }), "column 2, row 1"));
}

TEST(FirstHit, StraightDownIsExactlyAtTheHeight) {
    const HeightField map = random_field(2, 8, 8, true);
    for (const glm::dvec2 place : {glm::dvec2(0.5, 0.5), glm::dvec2(3, 3), glm::dvec2(0, 7.9), glm::dvec2(7.7, 0.2)}) {
        const auto hit = map.first_hit(down(place, {0, 0}), 1);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 1 - map.height(place), 1e-15);
        EXPECT_EQ(hit->texel, place);
        EXPECT_EQ(hit->cells, 1);
    }
}

TEST(FirstHit, OnAFlatMapIsAtTheMapsHeight) {
    for (const double height : {0.0, 0.25, 1.0})
        for (const glm::dvec2 along :
             {glm::dvec2(0, 0), glm::dvec2(3, -7), glm::dvec2(1e5, 2e5), glm::dvec2(-1e-9, 0)}) {
            const auto hit = field(4, 4, true, [&](int, int) { return height; }).first_hit(down({1, 2}, along), 1);
            ASSERT_TRUE(hit) << height;
            EXPECT_NEAR(hit->t, 1 - height, 1e-11) << height;
        }
}

TEST(FirstHit, OnARampIsTheIntersectionOfTwoLines) {
    const HeightField ramp = field(101, 3, false, [](int x, int) { return x / 100.0; });
    // The height (x - 0.5) / 100 equals 1 - t at x = 20.5 + 40 t: t = 0.8 / 1.4.
    const auto hit = ramp.first_hit(down({20.5, 1.3}, {40, 0}), 1);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 0.8 / 1.4, 1e-7) << "the map's heights are floats";
    EXPECT_NEAR(hit->texel.x, 20.5 + 40 * hit->t, 1e-12);
    EXPECT_EQ(hit->texel.y, 1.3);
}

TEST(FirstHit, InASaddleIsTheRootOfItsQuadratic) {
    // h = 1 at two opposite corners and 0 at the others: on the diagonal h = 1 - 2 s (1 - s).
    const HeightField saddle = field(2, 2, false, [](int x, int y) { return x == y; });
    // Along the diagonal at the constant height 3/4: the first hit is where 0.75 = 1 - 2 s (1 - s), from the middle
    // outwards.
    const auto out = saddle.first_hit({{1, 1, 0.75}, {1, 1, 0}}, 0.5);
    ASSERT_TRUE(out);
    EXPECT_NEAR(out->t, std::sqrt(0.125), 1e-15);
    // Along the other diagonal h = 2 s (1 - s). A ray at height 1/2 touches its top, and a ray slightly above does not.
    const auto touch = saddle.first_hit({{0.5, 1.5, 0.5}, {1, -1, 0}}, 1);
    ASSERT_TRUE(touch) << "a double root is a hit";
    EXPECT_NEAR(touch->t, 0.5, 1e-7);
    EXPECT_FALSE(saddle.first_hit({{0.5, 1.5, 0.5 + 1e-12}, {1, -1, 0}}, 1));
    const auto below = saddle.first_hit({{0.5, 1.5, 0.5 - 1e-6}, {1, -1, 0}}, 1);
    ASSERT_TRUE(below);
    EXPECT_NEAR(below->t, 0.5 - std::sqrt(0.5e-6), 1e-9) << "the first of two roots";
}

TEST(FirstHit, FindsAPostOfOneTexel) {
    const HeightField post = field(64, 64, false, [](int x, int y) { return x == 32 && y == 32; });
    // A horizontal ray at height 1/2 through the post's middle. The post's flank rises from 0 to 1 over one texel.
    const auto hit = post.first_hit({{0.5, 32.5, 0.5}, {1, 0, 0}}, 64);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->texel.x, 32, 1e-13);
    EXPECT_FALSE(post.first_hit({{0.5, 31.4, 0.5}, {1, 0, 0}}, 64)) << "beside it";
}

TEST(FirstHit, OnAPlateauAtTheRaysHeightIsThePlateausEdge) {
    const HeightField plateau = field(16, 4, false, [](int x, int) { return x >= 8; });
    const auto hit = plateau.first_hit({{0.5, 1.7, 1}, {1, 0, 0}}, 16);
    ASSERT_TRUE(hit) << "to touch is to hit";
    EXPECT_NEAR(hit->texel.x, 8.5, 1e-7);
    EXPECT_FALSE(plateau.first_hit({{0.5, 1.7, 1 + 1e-9}, {1, 0, 0}}, 16));
}

TEST(FirstHit, MatchesBruteForceOnRandomMaps) {
    const unsigned seed = 4;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    int compared = 0;
    for (const bool wraps : {true, false}) {
        const HeightField map = random_field(seed + wraps, 13, 9, wraps);
        for (int i = 0; i < 300; ++i) {
            const double reach = std::pow(10, between(-2, 1.6)), turn = between(0, 2 * M_PI);
            const Ray ray =
                down({between(-20, 40), between(-20, 40)}, {reach * std::cos(turn), reach * std::sin(turn)});
            const auto hit = map.first_hit(ray, 1);
            const double t = first_hit_by_force(map, ray);
            ASSERT_TRUE(hit);
            // Brute force may step over a grazing hit. The exact hit is then earlier, and on the surface.
            EXPECT_NEAR(ray.at(hit->t).z, map.height(hit->texel), 1e-12) << i;
            EXPECT_LE(hit->t, t + 1e-12) << i;
            compared += std::abs(hit->t - t) * reach < 1e-11;
        }
    }
    EXPECT_GE(compared, 598) << "the others are grazes between two of its steps";
}

TEST(FirstHit, DoesNotDependOnTheStartTile) {
    const HeightField map = random_field(6, 16, 8, true);
    for (const glm::dvec2 along : {glm::dvec2(30, 11), glm::dvec2(-5, 17), glm::dvec2(0, -20)}) {
        const auto here = map.first_hit(down({15.9, 0.1}, along), 1);
        for (const glm::dvec2 shift : {glm::dvec2(16, 0), glm::dvec2(-160, 80), glm::dvec2(16e6, -8e6)}) {
            const auto there = map.first_hit(down(glm::dvec2(15.9, 0.1) + shift, along), 1);
            ASSERT_TRUE(here && there);
            EXPECT_NEAR(there->t, here->t, 1e-8) << "16 million texels away a place has 9 digits left";
        }
    }
}

TEST(FirstHit, IsFoundAlongTheLinesBetweenCells) {
    const HeightField map = random_field(7, 8, 8, true);
    for (const glm::dvec2 along : {glm::dvec2(7, 0), glm::dvec2(0, -7), glm::dvec2(6, 6), glm::dvec2(-6, 6)}) {
        const Ray ray = down({2.5, 2.5}, along);
        const auto hit = map.first_hit(ray, 1);
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, first_hit_by_force(map, ray), 1e-11);
    }
}

TEST(FirstHit, AtGrazingAnglesIsFiniteOrReportsTheCellLimit) {
    const HeightField map = random_field(8, 32, 32, true);
    for (const double degrees : {80.0, 89.0, 89.9, 89.99}) {
        const double reach = 20 * std::tan(degrees * M_PI / 180);
        const auto hit = map.first_hit(down({3.3, 4.4}, {reach, reach / 3}), 1);
        ASSERT_TRUE(hit) << degrees;
        EXPECT_TRUE(std::isfinite(hit->texel.x) && hit->t >= 0 && hit->t <= 1);
    }
    const HeightField low = field(8, 8, true, [](int x, int y) { return x == 0 && y == 0 ? 1 : 0.5; });
    // A horizontal ray at height 0.7 along a row without the post never hits.
    EXPECT_TRUE(contains(message_of([&] { low.first_hit({{0, 4.5, 0.7}, {1, 0, 0}}, infinity); }), "cells"));
    EXPECT_FALSE(low.first_hit({{0, 4.5, 0.7}, {1, 0, 0}}, 1000));
}

TEST(FirstHit, IsEmptyForInvalidRays) {
    const HeightField map = random_field(9, 4, 4, true);
    const double nan = std::nan("");
    for (const double broken : {nan, infinity, -infinity}) {
        EXPECT_FALSE(map.first_hit({{broken, 0, 1}, {1, 1, -1}}, 1));
        EXPECT_FALSE(map.first_hit({{0, 0, 1}, {1, broken, -1}}, 1));
    }
    EXPECT_FALSE(map.first_hit(down({1, 1}, {1, 1}), nan));
    EXPECT_FALSE(map.first_hit(down({1, 1}, {1, 1}), -1));
    EXPECT_FALSE(map.first_hit({{1, 1, 2}, {0, 0, 0}}, infinity)) << "stands still in the air";
    EXPECT_TRUE(map.first_hit({{1, 1, -1}, {0, 0, 0}}, infinity)) << "stands still below the surface";
    EXPECT_FALSE(map.first_hit({{1, 1, 2}, {0, 0, 1}}, infinity)) << "leaves";
}

TEST(FirstHit, DoesNotChangeWithTheScaleOfTheDirection) {
    const HeightField map = random_field(10, 16, 16, true);
    const Ray ray = down({3.7, 9.1}, {12, -5});
    const double t = map.first_hit(ray, 1)->t;
    for (const double scale : {0x1p-60, 0x1p-20, 0x1p60}) {
        const auto hit = map.first_hit({ray.origin, scale * ray.direction}, infinity);
        ASSERT_TRUE(hit) << scale;
        EXPECT_NEAR(hit->t * scale, t, 1e-12) << scale;
    }
}

TEST(IsLit, IsTrueEverywhereOnAFlatMapAndNowhereFromBelow) {
    const HeightField flat = field(4, 4, true, [](int, int) { return 0.5; });
    for (const glm::dvec3 up : {glm::dvec3(0, 0, 1), glm::dvec3(1, 2, 0.01), glm::dvec3(-300, 1, 0.1)})
        EXPECT_TRUE(flat.is_lit({1.2, 3.4}, up));
    EXPECT_FALSE(flat.is_lit({1.2, 3.4}, {1, 0, -0.1}));
    EXPECT_FALSE(flat.is_lit({1.2, 3.4}, {1, 0, 0}));
}

TEST(IsLit, AWallThrowsAShadowAsLongAsItsHeightOverTheSlopeOfTheLight) {
    const HeightField wall = field(64, 2, false, [](int x, int) { return x == 20; });
    // Light from the left that falls by 1 in 10 texels: the shadow of the top at 20.5 ends at 30.5.
    const glm::dvec3 light(-10, 0, 1);
    EXPECT_FALSE(wall.is_lit({30.49, 1}, light));
    EXPECT_TRUE(wall.is_lit({30.51, 1}, light));
    EXPECT_TRUE(wall.is_lit({20.4, 1}, light)) << "the flank that looks at the light";
    EXPECT_FALSE(wall.is_lit({20.6, 1}, light)) << "the other one";
}

TEST(IsLit, IsTrueForLightThatGrazesASlope) {
    const HeightField ramp = field(11, 2, false, [](int x, int) { return x / 16.0; });
    EXPECT_TRUE(ramp.is_lit({2.3, 1}, {1, 0, 1 / 16.0}));
    EXPECT_FALSE(ramp.is_lit({2.3, 1}, {1, 0, 0.99 / 16}));
}

}  // namespace
}  // namespace relief
