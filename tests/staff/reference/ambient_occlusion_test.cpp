// Ambient occlusion by horizons, against a closed form and against rays.
#include "framework/staff/reference/ambient_occlusion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

#include "framework/library/maps/test_maps.h"
#include "framework/staff/reference/height_field.h"

namespace relief {
namespace {

// Jimenez et al. 2016: the cosine of the slope.
TEST(Occlusion, OfAnEndlessGrooveIsTheCosineOfItsSlope) {
    for (const double slope : {15.0, 30.0, 45.0}) {
        Image groove(65, 4, 1);
        for (int y = 0; y < 4; ++y)
            for (int x = 0; x < 65; ++x)
                *groove.pixel(x, y) = float(std::abs(x - 32) * std::tan(slope * glm::pi<double>() / 180) / 64);
        const Image open = occlusion_from_heights(groove, 64, 32, 24);
        EXPECT_NEAR(*open.pixel(32, 1), std::cos(slope * glm::pi<double>() / 180), 0.002) << slope;
    }
}

TEST(Occlusion, OfAReliefMatchesRayTracing) {
    constexpr double texels = 12;
    for (const HeightMap kind : {HeightMap::stones, HeightMap::bricks}) {
        const Image map = make_height_map(kind, 64);
        const Image open = occlusion_from_heights(map, texels, 16, 32);
        const HeightField field(map, true);
        std::mt19937 dice(7);
        double sum = 0;
        constexpr int places = 60, rays = 600;
        for (int i = 0; i < places; ++i) {
            const int x = int(dice() % 64), y = int(dice() % 64);
            const glm::dvec2 texel(x + 0.5, 63.5 - y);
            ASSERT_NEAR(field.height(texel), double(*map.pixel(x, y)), 1e-6);
            const glm::dvec3 normal = glm::normalize(glm::dvec3(-texels * field.central_slope(texel), 1));
            const glm::dvec3 side = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), normal));
            const glm::dvec3 up = glm::cross(normal, side);
            int free = 0;
            for (int ray = 0; ray < rays; ++ray) {
                const double turn = 2 * glm::pi<double>() * double(dice()) / 4294967296.0,
                             share = double(dice()) / 4294967296.0;
                const glm::dvec3 along =
                    std::sqrt(share) * (std::cos(turn) * side + std::sin(turn) * up) + std::sqrt(1 - share) * normal;
                const glm::dvec3 from(texel, field.height(texel) + 1e-6);
                const glm::dvec3 way(along.x, along.y, along.z / texels);
                const double far = way.z > 0 ? (field.highest() - from.z) / way.z + 1e-9 : 200;
                free += !field.first_hit({from, way}, std::min(far, 200.0));
            }
            const double off = std::abs(double(*open.pixel(x, y)) - double(free) / rays);
            EXPECT_LT(off, 0.2) << x << ", " << y << ": edges of a texel's width";
            sum += off;
        }
        EXPECT_LT(sum / places, 0.03) << int(kind) << ": rays alone scatter by 0.015";
    }
}

}  // namespace
}  // namespace relief
