// The evening sky.
#include "framework/library/kit/evening_sky.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

namespace relief {
namespace {

TEST(EveningSky, SendsTheLightOfTheIntegralsOfItsLobes) {
    const double pi = glm::pi<double>();
    glm::dvec3 expected(0);
    for (const Lobe& lobe : evening_lobes()) {
        EXPECT_NEAR(glm::length(lobe.middle), 1, 1e-12);
        const double k = lobe.sharpness;
        expected += lobe.color * (k > 0 ? 2 * pi / k * (1 - std::exp(-2 * k)) : 4 * pi);
    }
    // The midpoint rule over equal areas of the sphere. The sharpest lobe falls to 1/e within 3 degrees, which 8 rows
    // of the grid cover near the horizon.
    constexpr int rows = 700, columns = 1400;
    glm::dvec3 sum(0);
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double y = 2 * (row + 0.5) / rows - 1, r = std::sqrt(1 - y * y), turn = 2 * pi * column / columns;
            sum += evening_sky({r * std::sin(turn), y, r * std::cos(turn)}) * (4 * pi / (rows * columns));
        }
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], expected[c], 1e-3 * expected[c]);
}

}  // namespace
}  // namespace relief
