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
        for (const double value :
             {light.clamped, light.estevez, light.chiang, light.schuessler, light.exact, light.flat, light.flux})
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
    cases.insert(cases.end(), {{up, side, {0, 1, 0}}, {up, glm::normalize(glm::dvec3(1e-9, 0, 1)), up}});
    for (const double tiny : {1e-9, 1e-160, 1e-200, 1e-320})
        for (const glm::dvec3& way : {side, -side, glm::dvec3(0, 1, 0)})
            cases.push_back({up, {1, 0, tiny}, way + tiny * up});
    for (const auto& [surface, mapped, light] : cases) {
        const FacetLight facets = schuessler_light(surface, mapped, light);
        EXPECT_GE(facets.direct, 0);
        EXPECT_GE(facets.mirrored, -1e-15);
        EXPECT_LE(facets.sum(), 1 + 1e-12);
    }
    EXPECT_EQ(schuessler_light(up, side, up).sum(), 0) << "a mapped normal that lies in the base";
    EXPECT_EQ(estevez_shadow(up, up, -up), 0) << "a light below the base";
}

/// Follows the light into a saw of two facets in a plane across their edge. Slopes of the mapped normal fall from
/// height 0 to -tan, over a length of 1. Mirrors stand between them. Returns the light of the slopes.
FacetLight traced_facets(double tilt, const glm::dvec3& to_light, int rays) {
    const double tangent = std::tan(tilt);
    FacetLight light;
    for (int i = 0; i < rays; ++i) {
        const double x = (i + 0.5) / rays;  // at height 0
        // On its way down, the slope is at -tangent * x. The mirror stands at x = 1 and faces -x.
        const double run = -to_light.x / to_light.z;  // along x for each unit of height down
        const double down = tangent * x / (1 - tangent * run);
        const bool hits_slope = 1 - tangent * run > 0 && x + run * down <= 1;
        (hits_slope ? light.direct : light.mirrored) += to_light.z;
    }
    // Per area of the slopes, which is 1 / cos.
    return {light.direct * std::cos(tilt) / rays, light.mirrored * std::cos(tilt) / rays};
}

TEST(Terminator, TwoFacetsGetTheLightThatATracedSawGets) {
    const glm::dvec3 up(0, 0, 1);
    for (const double tilt : {0.1, 0.6, 1.2})
        for (const double elevation : {5.0, 25.0, 50.0, 85.0})
            for (const double azimuth : {0.0, 40.0, 90.0, 140.0, 180.0, 250.0}) {
                const glm::dvec3 light = light_at(elevation, azimuth), leaning(std::sin(tilt), 0, std::cos(tilt));
                const FacetLight traced = traced_facets(tilt, light, 20000);
                const FacetLight formula = schuessler_light(up, leaning, light);
                // The edge of a shadow crosses one ray in 20000.
                EXPECT_NEAR(formula.direct, traced.direct, 1e-4) << tilt << ' ' << elevation << ' ' << azimuth;
                EXPECT_NEAR(formula.mirrored, traced.mirrored, 1e-4) << tilt << ' ' << elevation << ' ' << azimuth;
            }
}

TEST(Terminator, TwoFacetsConserveTheLightThatFallsOnTheirBase) {
    std::mt19937 random(5);
    std::uniform_real_distribution angle(0.0, 360.0), height(0.1, 90.0);
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 up = light_at(height(random), angle(random));
        const glm::dvec3 mapped = light_at(height(random), angle(random)),
                         light = light_at(height(random), angle(random));
        const double upright = glm::dot(up, mapped), above = glm::dot(up, light);
        if (upright <= 0 || above <= 0) continue;
        // The mapped facet has an area of 1 / upright, and gets all the light of its base: by the mirror, if not
        // direct.
        EXPECT_NEAR(schuessler_light(up, mapped, light).sum() / upright, above, 1e-12);
    }
}

TEST(Terminator, TwoFacetsAreNearTheTruthOnAverageAndNoNearerThanNoMapByPlace) {
    const HeightField heights(sine_relief(64), true);
    const glm::dvec3 light = light_at(10, 37);
    const TileLight mean = tile_light(heights, 25, light, 128);
    EXPECT_NEAR(mean.schuessler / mean.exact, 1, 0.06);
    EXPECT_GT(mean.flat / mean.exact, 1.08);
    double facets = 0, flat = 0, guess = 0;
    for (const TileLight& place : place_lights(heights, 25, light, 128)) {
        facets += std::pow(place.schuessler - place.exact, 2);
        flat += std::pow(place.flat - place.exact, 2);
        guess += std::pow(place.estevez - place.exact, 2);
    }
    EXPECT_NEAR(std::sqrt(facets / flat), 1, 0.1);
    EXPECT_LT(guess, flat);
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
