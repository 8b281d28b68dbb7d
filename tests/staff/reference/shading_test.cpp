// Displacement, frames, light, levels and stored normals in double precision, against closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/displaced.h"
#include "framework/staff/reference/shading.h"
#include "framework/staff/reference/tangent_space.h"
#include "framework/staff/reference/tessellation.h"

namespace relief {
namespace {

TEST(Displaced, AtFullHeightOrWithoutScaleEqualsTheBase) {
    const SurfacePoint base = point_on(SphereShape{}, {0.3, 0.6});
    for (const DisplacedPoint& same : {displace(base, {1, {0, 0}}, 0.2), displace(base, {0.3, {5, 7}}, 0)}) {
        EXPECT_EQ(same.position, base.position);
        EXPECT_LT(degrees_between(same.normal, base.normal), 1e-12);
    }
}

TEST(Displaced, SphereWithConstantHeightIsASmallerSphere) {
    const DisplacedPoint inner = displace(point_on(SphereShape{.radius = 2}, {0.3, 0.6}), {0.25, {0, 0}}, 0.4);
    EXPECT_NEAR(glm::length(inner.position), 2 - 0.3, 1e-14);
    EXPECT_LT(degrees_between(inner.normal, inner.position), 1e-12);
    const DisplacedPoint point = displace(point_on(SphereShape{.radius = 2}, {0.3, 0.6}), {0, {0, 0}}, 2);
    EXPECT_LT(glm::length(point.position), 1e-15) << "all of it in one point";
    EXPECT_TRUE(std::isfinite(point.normal.x) && glm::length(point.normal) > 0.9);
}

TEST(Displaced, HasTheNormalOfItsOwnFiniteDifferences) {
    const double scale = 0.3, step = 1e-5;
    const auto height = [](glm::dvec2 p) { return 0.5 + 0.2 * std::sin(9 * p.x) * std::cos(7 * p.y); };
    const auto slope = [](glm::dvec2 p) {
        return glm::dvec2(1.8 * std::cos(9 * p.x) * std::cos(7 * p.y), -1.4 * std::sin(9 * p.x) * std::sin(7 * p.y));
    };
    const auto check = [&](const auto& shape) {
        for (const glm::dvec2 at : {glm::dvec2(0.1, 0.2), glm::dvec2(0.63, 0.5)}) {
            const auto moved = [&](glm::dvec2 p) { return displace(point_on(shape, p), {height(p), slope(p)}, scale); };
            const glm::dvec3 du = moved(at + glm::dvec2(step, 0)).position - moved(at - glm::dvec2(step, 0)).position;
            const glm::dvec3 dv = moved(at + glm::dvec2(0, step)).position - moved(at - glm::dvec2(0, step)).position;
            EXPECT_LT(degrees_between(moved(at).normal, glm::cross(du, dv)), 1e-6);
        }
    };
    check(QuadShape{}), check(ColumnShape{.top_radius = 0.7f}), check(SphereShape{});
}

TEST(Displaced, NormalsAreWrongIfTheBasesCurvatureIsIgnored) {
    // Slope 1 at a depth of 0.05 radii: Blinn's approximation has an error of atan(1 / (1 - 0.05)) - atan(1), 1.47
    // degrees.
    SurfacePoint base = point_on(ColumnShape{}, {0, 0.5});
    const HeightPoint height{0.5, {2 * M_PI / 0.1, 0}};  // dh/ds = 10 at radius 1, times a scale of 0.1
    const glm::dvec3 right = displace(base, height, 0.1).normal;
    EXPECT_NEAR(degrees_between(right, base.normal), glm::degrees(std::atan(1 / 0.95)), 1e-9);
    base.normal_du = {};
    EXPECT_NEAR(degrees_between(displace(base, height, 0.1).normal, right), glm::degrees(std::atan(1 / 0.95)) - 45,
                1e-9);
}

TEST(TangentFrame, IsAtRightAnglesAndKeepsTheNormalAndTheHandedness) {
    for (const double w : {1.0, -1.0}) {
        const glm::dmat3 frame = tangent_frame({0, 0, 3}, {2, 1, 7, w});
        EXPECT_LT(glm::length(frame[0] - glm::normalize(glm::dvec3(2, 1, 0))), 1e-15);
        EXPECT_LT(glm::length(frame[1] - w * glm::normalize(glm::dvec3(-1, 2, 0))), 1e-15);
        EXPECT_EQ(frame[2], glm::dvec3(0, 0, 1));
    }
}

TEST(TangentFrame, RoundTripsADirection) {
    const glm::dvec3 direction = glm::normalize(glm::dvec3(0.3, -0.5, 0.9)), normal(1, 2, -3);
    const glm::dvec4 tangent(0.5, -1, 2, -1);
    EXPECT_LT(
        glm::length(to_tangent_space(from_tangent_space(direction, normal, tangent), normal, tangent) - direction),
        1e-15);
}

TEST(BlinnPhong, IsLambertAndTheScaledHighlightAtItsPeak) {
    const glm::dvec3 up(0, 0, 1), albedo(0.5, 0.25, 0);
    EXPECT_EQ(blinn_phong(albedo, 0, 10, up, up, up), albedo) << "no specular: the cosine alone";
    EXPECT_EQ(blinn_phong({}, 0.1, 24, up, up, up), glm::dvec3(0.4)) << "(24 + 8) / 8 times 0.1";
    const glm::dvec3 slanted(0.6, 0, 0.8);
    EXPECT_LT(glm::length(blinn_phong(albedo, 0, 10, up, slanted, up) - 0.8 * albedo), 1e-15);
    EXPECT_EQ(blinn_phong(albedo, 1, 10, up, -slanted, up), glm::dvec3(0)) << "from behind";
    EXPECT_EQ(blinn_phong(albedo, 1, 10, up, up, -up), albedo) << "opposite: nothing between them";
}

TEST(TessellationLevel, FollowsDistanceSizeAndErrorWithinTheGlRange) {
    const auto by_distance = [](double away) {
        return level_by_distance({-1, 0, 0}, {1, 0, 0}, {0, away, 0}, 2, 10, 6, 0);
    };
    EXPECT_EQ(by_distance(1), 64);
    EXPECT_EQ(by_distance(6), 8) << "half way in the exponent";
    EXPECT_EQ(by_distance(99), 1);
    // 1 m at a distance of 10 m is 100 pixels at 1000 pixels per radian: 10 segments of 10 pixels.
    EXPECT_NEAR(level_by_size({-0.5, 0, 0}, {0.5, 0, 0}, {0, 0, 10}, 1000, 10), 10, 1e-12);
    EXPECT_NEAR(level_by_size({0, 0, -0.5}, {0, 0, 0.5}, {0, 0, 10}, 1000, 10), 10, 1e-12) << "end-on as well";
    EXPECT_EQ(level_by_size({0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 1000, 10), 1) << "0 / 0";
    EXPECT_EQ(level_by_size({-1, 0, 0}, {1, 0, 0}, {0, 0, 0}, 1000, 10), 64) << "the eye in its middle";
    // Half a pixel at 1000 pixels per radian and a distance of 2 m is 1 mm: 0.01 of a relief 0.1 m deep.
    EXPECT_NEAR(tolerated(2, 1000, 0.5, 0.1), 0.01, 1e-15);
    const std::array<double, 7> errors = {0.64, 0.32, 0.16, 0.08, 0.04, 0.02, 0.01};
    EXPECT_EQ(level_by_error(errors, 0.7), 1);
    EXPECT_EQ(level_by_error(errors, 0.16), 4);
    EXPECT_NEAR(level_by_error(errors, 0.12), std::exp2(2.5), 1e-12) << "half way in error, half way in the exponent";
    EXPECT_EQ(level_by_error(errors, 0.001), 64) << "none is tolerated";
    EXPECT_EQ(level_by_error({}, 0), 1) << "flat";
    EXPECT_EQ(level_by_error(errors, tolerated(0, 1000, 1, 0)), 1) << "nothing is pressed in";
}

TEST(ReliefBounds, ContainTheReliefTightly) {
    // A patch of a wall that faces +z, with a depth of 0.5: its relief lies 0.3 to 0.1 below the wall, along the axis.
    const glm::dvec4 bounds = relief_bounds({1, 2, 3, 0.5}, {0, 0, 1}, 0, 0.4, 0.8, 0.5);
    EXPECT_LT(glm::distance(bounds, glm::dvec4(1, 2, 3 - 0.2, 0.6)), 1e-15);
    // Half a metre along a direction that deviates by 0.1 ends 0.05 beside the axis.
    EXPECT_NEAR(relief_bounds({0, 0, 0, 1}, {0, 0, 1}, 0.1, 0, 0, 0.5).w, 1.05, 1e-15);
}

TEST(FacesAway, BeginsWhereTheConeAndTheSphereEnd) {
    const auto from = [](double degrees, double slope, double radius) {
        const double angle = glm::radians(degrees);
        return faces_away({0, 0, 1}, slope, {0, 0, 0, radius}, {10 * std::sin(angle), 0, 10 * std::cos(angle)});
    };
    EXPECT_FALSE(from(89, 0, 0));
    EXPECT_TRUE(from(91, 0, 0));
    EXPECT_FALSE(from(134, 1, 0)) << "45 degrees of slope";
    EXPECT_TRUE(from(136, 1, 0));
    EXPECT_FALSE(from(119, 0, 5)) << "a sphere seen within 30 degrees";
    EXPECT_TRUE(from(121, 0, 5));
    EXPECT_FALSE(from(180, 0, 10)) << "the eye in the sphere";
    EXPECT_FALSE(from(180, 1e30, 0));
}

TEST(TangentSpace, AnInterpolatedFrameRoundTripsAndDiffersFromGramSchmidt) {
    // Half-way between two corners of a cube with averaged normals. Both the normal and the tangent are shorter and
    // lean.
    const glm::dvec3 normal(0.4, 0, 0.577), n(0, 0, 1);
    for (const double side : {1.0, -1.0}) {
        const glm::dvec4 tangent(0.7, 0.1, -0.2, side);
        const glm::dvec3 stored = to_interpolated_frame(n, normal, tangent);
        EXPECT_LT(degrees_between(interpolated_frame(normal, tangent) * stored, n), 1e-12);
        EXPECT_NEAR(glm::length(stored), 1, 1e-15);
        EXPECT_GT(degrees_between(from_tangent_space(stored, normal, tangent), n), 4);
    }
    // If the frame is orthonormal, both methods agree.
    EXPECT_LT(degrees_between(to_interpolated_frame(n, {0.6, 0, 0.8}, {0.8, 0, -0.6, 1}),
                              to_tangent_space(n, {0.6, 0, 0.8}, {0.8, 0, -0.6, 1})),
              1e-12);
}

}  // namespace
}  // namespace relief
