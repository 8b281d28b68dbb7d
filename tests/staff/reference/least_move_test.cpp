// By how much a relief must move for a ray to meet it where somebody says.
#include "framework/staff/reference/least_move.h"

#include <gtest/gtest.h>

#include <random>

#include "framework/height/maps.h"

namespace relief {
namespace {

Image flat(float height) {
    Image image(8, 8, 1);
    std::fill(image.values.begin(), image.values.end(), height);
    return image;
}

TEST(LeastMove, OfAPlainIsWhatTheRayIsApartFromItWhereItIsSaidToMeetIt) {
    const HeightField field(flat(0.5f), true);
    const Ray ray{{3, 3, 1}, {4, 2, -1}};
    // A plain has no height above or below its own: every t is taken for that.
    EXPECT_NEAR(least_move(field, ray, 0.5).height, 0, 1e-12);
}

/// One texel at 1, all others at 0: a tent over the four cells around it.
Image tent() {
    Image image = flat(0);
    *image.pixel(4, 3) = 1;  // row 3 from the top is row 4 from below: its centre is at (4.5, 4.5)
    return image;
}

TEST(LeastMove, OfAPlaceBehindATentIsTheTentAboveTheRay) {
    const HeightField field(tent(), true);
    // Along the tent's ridge, from its left foot to beyond its right one: z = 1 - t, x = 3.5 + 4 t.
    const Ray ray{{3.5, 4.5, 1}, {4, 0, -1}};
    // At the top, t = 1/4, the tent is 1 and the ray 3/4; at the ground, t = 1, nothing stands.
    const ReliefMove move = least_move(field, ray, 1);
    EXPECT_NEAR(move.height, -0.25, 1e-12);
    EXPECT_NEAR(move.t, 0.25, 1e-12);
    // Uphill the tent is 4 t: met at t = 1/5.
    EXPECT_NEAR(least_move(field, ray, 0.2).height, 0, 1e-12);
    // Said to be met too early, the tent has to rise to the ray: 0.9 - 0.4.
    EXPECT_NEAR(least_move(field, ray, 0.1).height, 0.5, 1e-12);
    EXPECT_NEAR(least_move(field, ray, 0.1).t, 0.1, 1e-12);
}

TEST(LeastMove, FindsATopBetweenTheLinesOfACell) {
    const HeightField field(tent(), true);
    // Over the diagonal of a cell that falls from the tent's top to 0 as (1 - a)²; the ray begins below the surface's
    // chord.
    const Ray ray{{3.5, 4.0, 1.0}, {2, 1, -1}};
    const ReliefMove move = least_move(field, ray, 1);
    double largest = 0;
    for (int i = 0; i <= 100000; ++i) {
        const glm::dvec3 p = ray.at(i / 100000.0);
        largest = std::max(largest, field.height(glm::dvec2(p)) - p.z);
    }
    EXPECT_NEAR(-move.height, largest, 1e-9);
}

TEST(LeastMove, IsNothingExactlyAtTheFirstHit) {
    const HeightField field(make_height_map(HeightMap::stones, 64), true);
    std::mt19937 random(17);
    std::uniform_real_distribution<double> place(0, 64), reach(-60, 60);
    for (int i = 0; i < 500; ++i) {
        const Ray ray{{place(random), place(random), 1}, {reach(random), reach(random), -1}};
        const auto hit = field.first_hit(ray, 1);
        ASSERT_TRUE(hit);
        EXPECT_LT(std::abs(least_move(field, ray, hit->t).height), 1e-9);
        // A straight way up from there leaves the surface.
        if (hit->t > 0.05) {
            EXPECT_GT(least_move(field, ray, hit->t - 0.05).height, 0);
        }
    }
}

TEST(LeastMove, IsNoMoreThanASurfaceIsOff) {
    // What another relief shows, whose heights are off by 0.05 at most, is wrong by no more.
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
