// The orbit camera: its position and its rays.
#include "framework/core/lab/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

namespace relief {
namespace {

const Orbit orbits[] = {
    {},
    {.yaw = 0, .pitch = 0, .distance = 2},
    {.yaw = -123, .pitch = 89, .distance = 0.01, .target = {1, -2, 3}},
    {.yaw = 900, .pitch = -89, .distance = 1000, .target = {0, 50, 0}, .field_of_view = 90},
    {.yaw = 45, .pitch = 10, .distance = 7, .target = {0, 1.5, 0}, .field_of_view = 10},
};

glm::dvec3 project(const Camera& camera, glm::dvec3 point) {
    const glm::dvec4 clip = camera.clip_from_world() * glm::dvec4(point, 1);
    return glm::dvec3(clip) / clip.w;
}

void expect_near(glm::dvec3 a, glm::dvec3 b, double tolerance) {
    EXPECT_LT(glm::distance(a, b), tolerance)
        << a.x << ", " << a.y << ", " << a.z << " is not " << b.x << ", " << b.y << ", " << b.z;
}

TEST(Camera, ShowsItsTargetInTheCentre) {
    for (const Orbit& orbit : orbits) {
        const glm::dvec3 centre = project(Camera(orbit, 1.5), orbit.target);
        EXPECT_NEAR(centre.x, 0, 1e-12) << orbit.yaw;
        EXPECT_NEAR(centre.y, 0, 1e-12) << orbit.yaw;
        EXPECT_TRUE(centre.z > -1 && centre.z < 1) << centre.z << " is between near and far";
    }
}

TEST(Camera, LiesOnTheSphereAroundItsTarget) {
    for (const Orbit& orbit : orbits) {
        const Camera camera(orbit, 1);
        EXPECT_NEAR(glm::distance(camera.eye(), orbit.target), orbit.distance, 1e-12 * (orbit.distance + 100));
        expect_near(glm::dvec3(camera.view_from_world() * glm::dvec4(camera.eye(), 1)), {0, 0, 0}, 1e-9);
    }
    expect_near(Camera({.yaw = 0, .pitch = 0, .distance = 2}, 1).eye(), {0, 0, 2}, 1e-12);
    expect_near(Camera({.yaw = 90, .pitch = 0, .distance = 2}, 1).eye(), {2, 0, 0}, 1e-12);
    expect_near(Camera({.yaw = 0, .pitch = 30, .distance = 2}, 1).eye(), {0, 1, std::sqrt(3.0)}, 1e-12);
}

TEST(Camera, HasXToTheRightYUpAndItsFieldOfViewUpright) {
    const Orbit orbit{.yaw = 0, .pitch = 0, .distance = 3, .field_of_view = 40};
    // At the target's distance, the picture's upper edge is 3 tan(20 degrees) above the centre.
    const double top = 3 * std::tan(glm::radians(20.0));
    for (const double aspect : {0.5, 1.0, 16.0 / 9}) {
        const Camera camera(orbit, aspect);
        EXPECT_NEAR(project(camera, {0, top, 0}).y, 1, 1e-12);
        EXPECT_NEAR(project(camera, {top * aspect, 0, 0}).x, 1, 1e-12) << aspect;
    }
}

TEST(Camera, RaysPassThroughPointsThatProjectToTheirPixel) {
    const unsigned seed = 11;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> clip(-1, 1), depth(0.1, 5);
    for (const Orbit& orbit : orbits)
        for (int i = 0; i < 100; ++i) {
            const Camera camera(orbit, 1.6);
            const glm::dvec2 place(clip(random), clip(random));
            const Ray ray = camera.ray(place);
            ASSERT_NEAR(glm::length(ray.direction), 1, 1e-14);
            ASSERT_EQ(ray.origin, camera.eye());
            const glm::dvec3 hit = project(camera, ray.origin + depth(random) * orbit.distance * ray.direction);
            ASSERT_LT(glm::distance(glm::dvec2(hit), place), 1e-9) << "yaw " << orbit.yaw << ", seed " << seed;
            ASSERT_LT(std::abs(hit.z), 1) << "in front of the camera, yaw " << orbit.yaw << ", seed " << seed;
        }
}

TEST(Camera, DoesNotPassOverThePoles) {
    for (const double pitch : {89.0, 89.5, 90.0, 120.0, 1e9}) {
        EXPECT_EQ(Camera({.pitch = pitch}, 1).orbit().pitch, 89) << pitch;
        EXPECT_EQ(Camera({.pitch = -pitch}, 1).orbit().pitch, -89) << pitch;
        expect_near(Camera({.pitch = pitch}, 1).eye(), Camera({.pitch = 89}, 1).eye(), 1e-15);
    }
    for (const double pitch : {-89.0, 89.0}) {
        const glm::dmat4 view = Camera({.pitch = pitch}, 1).view_from_world();
        EXPECT_NEAR(glm::determinant(view), 1, 1e-9) << "still a rotation at " << pitch;
    }
}

}  // namespace
}  // namespace relief
