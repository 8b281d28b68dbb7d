// Parallelograms and boxes with uv in metres, and meshes of several parts.
#include "framework/library/mesh/parallelogram.h"

#include <gtest/gtest.h>

namespace relief {
namespace {

TEST(Parallelogram, HasItsAreaItsPlaneAndUvInMetres) {
    const Parallelogram shape{.corner = {1, 2, 3}, .right = {2, 0, 0.5}, .up = {0.5, 1, -2}, .cells = 3, .tile = 0.5};
    const Mesh mesh = make_parallelogram(shape);
    const glm::dvec3 across = glm::cross(shape.right, shape.up), normal = glm::normalize(across);
    glm::dvec3 area(0);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
        area += glm::cross(glm::dvec3(b.position - a.position), glm::dvec3(c.position - a.position)) / 2.0;
        // The uv are an isometry but for the tile. Positions are floats below 8, with errors up to 2.4e-7.
        EXPECT_NEAR(glm::distance(a.uv, b.uv) * 0.5f, glm::distance(a.position, b.position), 2e-6);
        EXPECT_NEAR(glm::distance(a.uv, c.uv) * 0.5f, glm::distance(a.position, c.position), 2e-6);
    }
    EXPECT_LT(glm::distance(area, across), 1e-5) << "18 triangles that face across";
    for (const Vertex& vertex : mesh.vertices) {
        EXPECT_NEAR(glm::dot(glm::dvec3(vertex.position) - shape.corner, normal), 0, 1e-6);
        EXPECT_NEAR(glm::dot(glm::dvec3(vertex.normal), normal), 1, 1e-6);
        EXPECT_NEAR(glm::dot(glm::vec3(vertex.tangent), vertex.normal), 0, 1e-6);
        EXPECT_NEAR(vertex.tangent.y, 0, 1e-6) << "u is horizontal";
    }
}

TEST(Parallelogram, OnAGroundURunsAlongXAndVAlongMinusZ) {
    const PlaneAxes axes = plane_axes({0, 1, 0});
    EXPECT_EQ(axes.right, glm::dvec3(1, 0, 0));
    EXPECT_EQ(axes.up, glm::dvec3(0, 0, -1));
}

TEST(Block, HasSixOutwardFacesWithUvInMetres) {
    const glm::vec3 low(-1, 2, 0.5f), high(1, 3, 4), middle = (low + high) / 2.0f;
    const Mesh mesh = make_block(low, high, 0.5);
    ASSERT_EQ(mesh.vertices.size(), 24u);
    float area = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 across = glm::cross(b.position - a.position, c.position - a.position);
        EXPECT_GT(glm::dot(across, a.position - middle), 0) << "faces outwards";
        EXPECT_NEAR(glm::dot(glm::normalize(across), a.normal), 1, 1e-6);
        EXPECT_NEAR(glm::distance(a.uv, b.uv) * 0.5f, glm::distance(a.position, b.position), 2e-6);
        area += glm::length(across) / 2;
    }
    EXPECT_NEAR(area, 2 * (2 * 1 + 1 * 3.5 + 2 * 3.5), 1e-5);
    for (const Vertex& vertex : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_TRUE(vertex.position[axis] == low[axis] || vertex.position[axis] == high[axis]);
}

TEST(Append, MovesAPartAndRepeatsItsTexture) {
    const Mesh part = make_parallelogram({.corner = {0, 0, 0}, .right = {1, 0, 0}, .up = {0, 1, 0}});
    Mesh mesh = part;
    append(mesh, part, {5, 0, 0}, {2, 3});
    ASSERT_EQ(mesh.vertices.size(), 8u);
    EXPECT_EQ(mesh.vertices[7].position, glm::vec3(6, 1, 0));
    EXPECT_EQ(mesh.vertices[7].uv, glm::vec2(2, 3));
    for (size_t i = 0; i < part.indices.size(); ++i)
        EXPECT_EQ(mesh.indices[part.indices.size() + i], part.indices[i] + 4);
}

}  // namespace
}  // namespace relief
