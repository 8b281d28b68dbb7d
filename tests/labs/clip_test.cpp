// The visible part of a polygon.
#include "labs/17_time_and_error/clip.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

namespace relief {
namespace {

constexpr unsigned clip_seed = 17;

/// Returns how far a point is inside a convex, counter-clockwise polygon, in areas; below 0 outside.
double inside(const std::vector<ClipCorner>& polygon, const glm::dvec2& point) {
    double least = polygon.empty() ? -1 : 1e30;
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i].place, b = polygon[(i + 1) % polygon.size()].place;
        least = std::min(least, (b.x - a.x) * (point.y - a.y) - (b.y - a.y) * (point.x - a.x));
    }
    return least;
}

TEST(Clipped, HoldsExactlyTheVisiblePointsOfASquare) {
    std::mt19937 random(clip_seed);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    constexpr double rounding = 1e-9;  // points this near a border count on either side
    int seen = 0, hidden = 0;
    for (int i = 0; i < 500; ++i) {
        // Clip space is any linear map of (x, y, 1): an arbitrary plane under an arbitrary projection.
        glm::dmat4x3 rows;
        for (int row = 0; row < 4; ++row) rows[row] = {between(-1, 1), between(-1, 1), between(-1, 1)};
        const auto clip = [&](const glm::dvec2& place) {
            const glm::dvec3 at(place, 1);
            return glm::dvec4(glm::dot(rows[0], at), glm::dot(rows[1], at), glm::dot(rows[2], at),
                              glm::dot(rows[3], at));
        };
        const glm::dvec2 grown(between(0.8, 1.2), between(0.8, 1.2));
        std::vector<ClipCorner> square;
        for (const glm::dvec2 place : {glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
            square.push_back({place, clip(place)});
        const std::vector<ClipCorner> part = clipped(square, grown);
        for (const ClipCorner& corner : part)
            for (int axis = 0; axis < 4; ++axis)
                EXPECT_NEAR(corner.clip[axis], clip(corner.place)[axis], rounding) << "a corner is one point";
        for (int k = 0; k < 200; ++k) {
            const glm::dvec2 point(between(-1, 1), between(-1, 1));
            const glm::dvec4 at = clip(point);
            const double space =
                std::min({grown.x * at.w - std::abs(at.x), grown.y * at.w - std::abs(at.y), at.w - std::abs(at.z)});
            if (std::abs(space) < rounding || std::abs(inside(part, point)) < rounding) continue;
            ASSERT_EQ(space > 0, inside(part, point) > 0) << "polygon " << i << " at " << point.x << ", " << point.y;
            ++(space > 0 ? seen : hidden);
        }
    }
    EXPECT_GT(seen, 1000);
    EXPECT_GT(hidden, 1000);
}

}  // namespace
}  // namespace relief
