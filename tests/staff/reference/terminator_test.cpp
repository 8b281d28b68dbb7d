// The bump terminator: published factors, and the light of a whole relief against a law that holds for all.
#include "framework/staff/reference/terminator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

#include "tests/support.h"

namespace relief {
namespace {

glm::dvec3 light_at(double elevation, double azimuth) {
    const double up = glm::radians(elevation), around = glm::radians(azimuth);
    return {std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up)};
}

TEST(Terminator, WhatReachesATileFallsThroughItsBase) {
    const HeightField heights(sine_relief(64), true);
    for (const double depth : {4.0, 20.0, 60.0})
        for (const double elevation : {8.0, 30.0, 60.0}) {
            const glm::dvec3 light = light_at(elevation, 37);
            // 512 x 512 places: the edge of a shadow crosses a thousandth of them.
            EXPECT_NEAR(tile_light(heights, depth, light, 512).flux, light.z, 0.004) << depth << ' ' << elevation;
        }
}

TEST(Terminator, AFlatMapIsNotShaded) {
    const HeightField flat(Image(8, 8, 1), true);
    for (const double elevation : {1.0, 20.0, 90.0}) {
        const TileLight light = tile_light(flat, 5, light_at(elevation, 10), 8);
        const double sine = std::sin(glm::radians(elevation));
        for (const double value : {light.clamped, light.estevez, light.chiang, light.exact, light.flat, light.flux})
            EXPECT_NEAR(value, sine, 1e-12) << elevation;
    }
}

TEST(Terminator, GuessesHaveTheValuesOfTheirFormulas) {
    // Worked by hand. A map that leans by 45 degrees: c^2 = 1/2, a = 1/8. A light at 30 degrees: t = 3.
    const glm::dvec3 up(0, 0, 1), leaning = glm::normalize(glm::dvec3(1, 0, 1));
    EXPECT_NEAR(estevez_shadow(up, leaning, light_at(30, 0)), 2 / (1 + std::sqrt(1.375)), 1e-12);
    // g = sin 30 / (cos 15 cos 45).
    const double g = 0.5 / (std::cos(glm::radians(15.0)) * std::sqrt(0.5));
    EXPECT_NEAR(chiang_shadow(up, leaning, light_at(30, 0)), -g * g * g + g * g + g, 1e-12);
    // A slope of 3 has a = 9/8, limited to 1.
    const glm::dvec3 steep = glm::normalize(glm::dvec3(3, 0, 1));
    EXPECT_NEAR(estevez_shadow(up, steep, light_at(45, 0)), 2 / (1 + std::sqrt(2.0)), 1e-12);
}

TEST(Terminator, GuessesAreFiniteAndBetween0And1EverywhereAndAtTheirEnds) {
    std::mt19937 random(3);
    std::normal_distribution one(0.0, 1.0);
    const auto unit = [&] { return glm::normalize(glm::dvec3(one(random), one(random), one(random))); };
    std::vector<std::array<glm::dvec3, 3>> cases;
    for (int i = 0; i < 10000; ++i) cases.push_back({unit(), unit(), unit()});
    const glm::dvec3 up(0, 0, 1), side(1, 0, 0);
    cases.insert(cases.end(), {{up, side, side}, {up, side, up}, {up, -up, up}, {up, up, side}, {up, up, -up}});
    for (const auto& [surface, mapped, light] : cases)
        for (const double value : {estevez_shadow(surface, mapped, light), chiang_shadow(surface, mapped, light)}) {
            EXPECT_GE(value, 0);
            EXPECT_LE(value, 1 + 1e-12);
        }
    EXPECT_EQ(estevez_shadow(up, up, -up), 0) << "a light below the base";
}

TEST(Terminator, WithoutAShadowALowLightIsTooBrightAndTheGuessesAreNearer) {
    const HeightField heights(sine_relief(64), true);
    const glm::dvec3 light = light_at(8, 37);
    const TileLight tile = tile_light(heights, 20, light, 256);
    EXPECT_GT(tile.clamped, 1.3 * tile.exact);
    EXPECT_LT(std::abs(tile.estevez - tile.exact), 0.6 * (tile.clamped - tile.exact));
    EXPECT_LT(std::abs(tile.chiang - tile.exact), tile.clamped - tile.exact);
}

}  // namespace
}  // namespace relief
