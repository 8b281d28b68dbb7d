// Sections of meshes by planes.
#include "labs/07_baking/section.h"

#include <gtest/gtest.h>

#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

TEST(PlaneSection, OfASphereIsACircleOfItsCircumference) {
    const Mesh sphere = make_sphere({.radius = 2, .sides = 256, .rows = 128});
    double length = 0;
    for (const auto& [a, b] : plane_section(sphere, {0.3, 1, 0.2})) {
        length += glm::distance(a, b);
        for (const glm::dvec3& end : {a, b}) {
            EXPECT_NEAR(glm::dot(end, glm::dvec3(0.3, 1, 0.2)), 0, 1e-6);
            EXPECT_NEAR(glm::length(end), 2, 0.001) << "a chord of 1/256 of a turn is 0.0002 lower";
        }
    }
    EXPECT_NEAR(length, 2 * 3.14159265 * 2, 0.002);
}

TEST(PlaneSection, HasNoLineBesideTheMeshAndNoneForATriangleInThePlane) {
    Mesh quad = make_quad({.width = 2, .height = 2});  // in the plane z = 0
    EXPECT_TRUE(plane_section(quad, {0, 0, 1}).empty());
    EXPECT_EQ(plane_section(quad, {0, 5, 0}).size(), 2u) << "both triangles of the quad, with a normal of any length";
    for (Vertex& vertex : quad.vertices) vertex.position.y += 1.5f;
    EXPECT_TRUE(plane_section(quad, {0, 5, 0}).empty());
    EXPECT_TRUE(plane_section({}, {0, 0, 1}).empty());
}

}  // namespace
}  // namespace relief
