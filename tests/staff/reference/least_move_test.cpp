// The smallest change of height with which a ray would hit a relief at a claimed place.
#include "framework/staff/reference/least_move.h"

#include <gtest/gtest.h>

#include <random>

#include "framework/library/maps/test_maps.h"

namespace relief {
namespace {

Image flat(float height) {
    Image image(8, 8, 1);
    std::fill(image.values.begin(), image.values.end(), height);
    return image;
}

TEST(LeastMove, OnAPlaneEqualsTheGapAtTheClaimedHit) {
    const HeightField field(flat(0.5f), true);
    const Ray ray{{3, 3, 1}, {4, 2, -1}};
    // On a plane, every claimed t has the plane's own height.
    EXPECT_NEAR(least_move(field, ray, 0.5).height, 0, 1e-12);
}

/// One texel at 1, all others at 0: a tent over the four cells around it.
Image tent() {
    Image image = flat(0);
    *image.pixel(4, 3) = 1;  // row 3 from the top is row 4 from below: its centre is at (4.5, 4.5)
    return image;
}

TEST(LeastMove, BehindATentIsTheTentsHeightAboveTheRay) {
    const HeightField field(tent(), true);
    // Along the tent's ridge, from its left foot to beyond its right foot: z = 1 - t, x = 3.5 + 4 t.
    const Ray ray{{3.5, 4.5, 1}, {4, 0, -1}};
    // At the top, t = 1/4, the tent is at 1 and the ray at 3/4. At t = 1 the ray is on the ground.
    const ReliefMove move = least_move(field, ray, 1);
    EXPECT_NEAR(move.height, -0.25, 1e-12);
    EXPECT_NEAR(move.t, 0.25, 1e-12);
    // On the rising side the tent's height is 4 t, which the ray hits at t = 1/5.
    EXPECT_NEAR(least_move(field, ray, 0.2).height, 0, 1e-12);
    // If the claimed hit is too early, the tent must rise to the ray: 0.9 - 0.4.
    EXPECT_NEAR(least_move(field, ray, 0.1).height, 0.5, 1e-12);
    EXPECT_NEAR(least_move(field, ray, 0.1).t, 0.1, 1e-12);
}

TEST(LeastMove, FindsAMaximumInsideACell) {
    const HeightField field(tent(), true);
    // The ray crosses a cell along whose diagonal the tent falls from 1 to 0 as (1 - a)². It begins below the chord of
    // the surface.
    const Ray ray{{3.5, 4.0, 1.0}, {2, 1, -1}};
    const ReliefMove move = least_move(field, ray, 1);
    double largest = 0;
    for (int i = 0; i <= 100000; ++i) {
        const glm::dvec3 p = ray.at(i / 100000.0);
        largest = std::max(largest, field.height(glm::dvec2(p)) - p.z);
    }
    EXPECT_NEAR(-move.height, largest, 1e-9);
}

TEST(LeastMove, IsZeroAtTheFirstHit) {
    const HeightField field(make_height_map(HeightMap::stones, 64), true);
    std::mt19937 random(17);
    std::uniform_real_distribution<double> place(0, 64), reach(-60, 60);
    for (int i = 0; i < 500; ++i) {
        const Ray ray{{place(random), place(random), 1}, {reach(random), reach(random), -1}};
        const auto hit = field.first_hit(ray, 1);
        ASSERT_TRUE(hit);
        EXPECT_LT(std::abs(least_move(field, ray, hit->t).height), 1e-9);
        // From the hit backwards along the ray, the surface would have to rise.
        if (hit->t > 0.05) {
            EXPECT_GT(least_move(field, ray, hit->t - 0.05).height, 0);
        }
    }
}

TEST(LeastMove, NeverExceedsTheHeightErrorOfTheSurface) {
    // The hits on another relief, whose heights differ by at most 0.05, are wrong by at most 0.05.
    const Image image = make_height_map(HeightMap::stones, 64);
    Image other = image;
    std::mt19937 random(18);
    std::uniform_real_distribution<double> place(0, 64), reach(-60, 60), off(-0.05, 0.05);
    for (float& height : other.values) height = float(double(height) + off(random));
    const HeightField field(image, true), shown(other, true);
    double largest = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray{{place(random), place(random), 1.05}, {reach(random), reach(random), -1}};
        const auto hit = shown.first_hit(ray, 1.1);
        if (!hit) continue;
        largest = std::max(largest, std::abs(least_move(field, ray, hit->t).height));
    }
    EXPECT_LE(largest, 0.05 + 1e-7);
    EXPECT_GT(largest, 0.03);
}

}  // namespace
}  // namespace relief
