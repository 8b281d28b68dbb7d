// Eyes at any place: their rays, and the spheres that they miss.
#include "labs/09_planet/eye.h"

#include <gtest/gtest.h>

#include <random>

namespace relief {
namespace {

TEST(Eye, OfACameraHasItsRays) {
    const Camera camera({.yaw = 30, .pitch = -20, .distance = 4, .target = {1, 2, 3}, .field_of_view = 50}, 1.5);
    const Eye eye = Eye::of(camera, 1.5);
    for (const glm::dvec2 clip : {glm::dvec2(0, 0), glm::dvec2(-1, 1), glm::dvec2(0.3, -0.7)}) {
        const Ray ray = eye.ray(clip), wanted = camera.ray(clip);
        EXPECT_LT(glm::distance(ray.origin, wanted.origin), 1e-12);
        EXPECT_LT(glm::distance(ray.direction, glm::normalize(wanted.direction)), 1e-12);
    }
}

TEST(Eye, LooksAlongItsVectorWithUpUpwards) {
    const glm::dvec3 along = glm::normalize(glm::dvec3(1, -2, 0.5));
    const Eye eye = Eye::looking({5, 6, 7}, along, {0, 1, 0}, 0.8, 2);
    EXPECT_LT(glm::distance(eye.ray({0, 0}).direction, along), 1e-12);
    EXPECT_GT(eye.ray({0, 1}).direction.y, along.y);
    EXPECT_NEAR(std::acos(glm::dot(eye.ray({0, -1}).direction, eye.ray({0, 1}).direction)), 0.8, 1e-12);
}

TEST(Eye, MissesNoSphereThatARayOfItsPictureMeets) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    const Eye eye = Eye::looking({1, 2, 3}, glm::normalize(glm::dvec3(-1, 0.2, -0.5)), {0, 1, 0}, 1.1, 1.6);
    int missed = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray = eye.ray({number(random), number(random)});
        const double radius = 0.5 + 0.5 * number(random), away = 5 + 5 * number(random);
        const glm::dvec3 aside(number(random), number(random), number(random));
        EXPECT_FALSE(eye.misses(ray.at(away) + 0.99 * radius * glm::normalize(aside), radius));
        missed += eye.misses(eye.place + 10.0 * glm::normalize(aside), 0.1);
    }
    EXPECT_GT(missed, 1000) << "most places around the eye are not in its picture";
}

}  // namespace
}  // namespace relief
