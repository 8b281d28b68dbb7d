// Bounds of the directions that a displaced patch can face: no chord is steeper.
#include "labs/14_adaptive_displacement/facing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace relief {
namespace {

constexpr unsigned facing_seed = 14;

/// A random patch of 3 or 4 corners with directions of displacement, and a relief of waves on it.
class Displaced {
public:
    Displaced(int corners, std::mt19937& random) : random_(random), corners_(size_t(corners)) {
        constexpr glm::vec2 square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        for (size_t i = 0; i < corners_; ++i) {
            PatchCorner corner{};
            corner.vertex.position = {square[i].x + between(-0.2, 0.2), square[i].y + between(-0.2, 0.2),
                                      between(-0.2, 0.2)};
            corner.vertex.uv = corner.height_uv = square[i];
            corner.direction = glm::normalize(glm::vec3(between(-0.3, 0.3), between(-0.3, 0.3), 1));
            patch_.push_back(corner);
        }
        for (size_t i = 0; i < corners_; ++i)
            patch_[i].edge_uv = {patch_[i].vertex.uv, patch_[(i + 1) % corners_].vertex.uv};
        wave_ = {between(-8, 8), between(-8, 8), between(-8, 8)};
    }

    /// Returns bounds of the heights, and their exact slope: no wave is steeper than its amplitude times its number.
    PatchHeights heights() const {
        PatchHeights heights{};
        heights.lowest = float(0.5 - amplitude), heights.highest = float(0.5 + amplitude);
        heights.slope = float(amplitude * glm::length(wave_));
        return heights;
    }
    std::span<const PatchCorner> patch() const { return patch_; }

    struct Point {
        glm::dvec3 smooth, displaced;
    };
    /// Returns a random point of the smooth patch, p - E D, and of the displaced one, p - depth D / |D|.
    Point point() {
        double u = between(0, 1), v = between(0, 1);
        std::vector<double> weights = {(1 - u) * (1 - v), u * (1 - v), u * v, (1 - u) * v};
        if (corners_ == 3) {
            if (u + v > 1) u = 1 - u, v = 1 - v;
            weights = {1 - u - v, u, v};
        }
        glm::dvec3 place(0), direction(0);
        for (size_t i = 0; i < corners_; ++i) {
            place += weights[i] * glm::dvec3(patch_[i].vertex.position);
            direction += weights[i] * glm::dvec3(patch_[i].direction);
        }
        const double height = 0.5 + amplitude * std::sin(glm::dot(wave_, place));
        return {place - scale * 0.5 * direction, place - scale * (1 - height) * glm::normalize(direction)};
    }

    static constexpr double scale = 0.2, amplitude = 0.4;

private:
    double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }

    std::mt19937& random_;
    size_t corners_;
    std::vector<PatchCorner> patch_;
    glm::dvec3 wave_;
};

TEST(Facing, NoChordRisesOrShiftsMoreThanItsBounds) {
    std::mt19937 random(facing_seed);
    double tightest = 0;
    for (int i = 0; i < 400; ++i) {
        Displaced displaced(3 + i % 2, random);
        const Facing facing = facing_of(displaced.patch(), displaced.heights(), Displaced::scale);
        ASSERT_TRUE(std::isfinite(facing.rise)) << "these patches do not fold over";
        for (int chord = 0; chord < 200; ++chord) {
            const auto a = displaced.point(), b = displaced.point();
            const auto across = [&](const glm::dvec3& v) { return v - facing.axis * glm::dot(facing.axis, v); };
            const glm::dvec3 smooth = across(b.smooth - a.smooth), whole = b.displaced - a.displaced;
            const double length = glm::length(smooth), rise = std::abs(glm::dot(facing.axis, whole));
            // A thousandth of a millionth for rounding: corners and directions are floats, but exactly as given.
            ASSERT_LE(rise, facing.rise * length + 1e-9) << "patch " << i;
            ASSERT_LE(glm::length(across(whole) - smooth), facing.shift * length + 1e-9) << "patch " << i;
            tightest = std::max(tightest, rise / (facing.rise * length));
        }
    }
    EXPECT_GT(tightest, 0.7) << "a bound that is far off culls nothing";
}

TEST(Facing, TheSphereHoldsAllCornersAndTheSpreadAllDirections) {
    std::mt19937 random(facing_seed);
    for (int i = 0; i < 400; ++i) {
        const Displaced displaced(3 + i % 2, random);
        const Facing facing = facing_of(displaced.patch(), displaced.heights(), Displaced::scale);
        for (const PatchCorner& corner : displaced.patch()) {
            EXPECT_LE(glm::distance(glm::dvec3(facing.sphere), glm::dvec3(corner.vertex.position)), facing.sphere.w);
            EXPECT_LE(glm::distance(facing.axis, glm::dvec3(corner.direction)), facing.spread);
        }
    }
}

TEST(Facing, HasNoBoundForFoldedPatchesAndForJumpsOfTheMap) {
    PatchHeights heights{};
    heights.highest = heights.slope = 1;
    std::vector<PatchCorner> patch(4);
    for (size_t i = 0; i < 4; ++i) {
        patch[i].vertex.position = {i == 1 || i == 2, i > 1, 0};
        patch[i].vertex.uv = patch[i].height_uv = glm::vec2(patch[i].vertex.position);
        patch[i].direction = {0, 0, 1};
    }
    for (size_t i = 0; i < 4; ++i) patch[i].edge_uv = {patch[i].vertex.uv, patch[(i + 1) % 4].vertex.uv};
    EXPECT_TRUE(std::isfinite(facing_of(patch, heights, 0.1).rise));
    auto jumping = patch;
    jumping[1].height_uv.x += 0.25f;
    EXPECT_TRUE(std::isinf(facing_of(jumping, heights, 0.1).rise));
    EXPECT_TRUE(std::isfinite(facing_of(jumping, heights, 0.1).flat_rise)) << "without displacement none is read";
    jumping[1].height_uv.x += 0.75f;
    EXPECT_TRUE(std::isfinite(facing_of(jumping, heights, 0.1).rise)) << "a whole tile shows the same heights";
    std::swap(patch[1].vertex.position, patch[2].vertex.position);
    EXPECT_TRUE(std::isinf(facing_of(patch, heights, 0.1).flat_rise));
}

}  // namespace
}  // namespace relief
