// The shadow of a studio's floor.
#include "framework/library/kit/studio.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

TEST(Studio, HidesTheShareOfTheSkyThatASphereCovers) {
    // A sphere above the horizon covers a cone about the direction to its middle, of half angle asin(radius /
    // distance). The cosine's integral over that cone is pi sin² times the cosine of its axis; over the whole sky it is
    // pi.
    constexpr double radius = 0.5, up = 0.9;
    const std::vector<Facet> facets = facets_of(make_sphere({.radius = float(radius), .sides = 48, .rows = 24}),
                                                glm::translate(glm::dmat4(1), glm::dvec3(3, up, -2)));
    for (const double aside : {0.0, 0.5, 1.0, 2.0, 4.0}) {
        const double distance = std::hypot(up, aside);
        const double expected = radius * radius / (distance * distance) * up / distance;
        EXPECT_NEAR(hidden_sky(facets, {3 + aside, 0, -2}), expected, 0.02) << aside;
        EXPECT_NEAR(hidden_sky(facets, {3, 0, -2 - aside}), expected, 0.02) << aside;
    }
}

TEST(Studio, HidesHalfOfTheSkyAtTheFootOfALongWall) {
    // From its foot a wall without ends covers a quarter of a circle on one side: half of the cosine's integral.
    const Mesh wall = make_quad({.width = 40, .height = 20, .columns = 80, .rows = 40});
    const std::vector<Facet> facets = facets_of(wall, glm::translate(glm::dmat4(1), glm::dvec3(0, 10, 0)));
    for (const double side : {-1.0, 1.0}) EXPECT_NEAR(hidden_sky(facets, {0, 0, 2 * side}), 0.45, 0.05) << side;
}

TEST(Studio, KeepsTheAreaAndTheDirectionsOfAMeshInItsFacets) {
    const Mesh box = make_box({.size = glm::vec3(1, 2, 3), .cells = glm::ivec3(40)});
    double size = 0;
    glm::dvec3 sum(0);
    const std::vector<Facet> facets = facets_of(box);
    for (const Facet& facet : facets) size += glm::length(facet.area), sum += facet.area;
    EXPECT_NEAR(size, 2 * (2 + 3 + 6), 1e-4);
    EXPECT_NEAR(glm::length(sum), 0, 1e-4);
    EXPECT_LT(facets.size(), box.indices.size() / 3 / 4);
}

}  // namespace
}  // namespace relief
