// Every shape against its own positions: the frame of a vertex agrees with its neighbours.
#include "framework/library/mesh/shapes.h"

#include <algorithm>
#include <cmath>

#include "tests/support.h"

namespace relief {
namespace {

struct Grid {
    const char* name;
    Mesh mesh;
    int columns, rows;
    glm::vec2 repeat{1, 1};

    const Vertex& at(int column, int row) const { return mesh.vertices.at(size_t(row * (columns + 1) + column)); }
    /// Central differences of the position over two columns or two rows.
    glm::dvec3 along_u(int column, int row) const {
        return glm::dvec3(at(column + 1, row).position) - glm::dvec3(at(column - 1, row).position);
    }
    glm::dvec3 along_v(int column, int row) const {
        return glm::dvec3(at(column, row + 1).position) - glm::dvec3(at(column, row - 1).position);
    }
};

std::vector<Grid> shapes() {
    return {
        {"quad", make_quad({.width = 3, .height = 0.5f, .columns = 4, .rows = 3, .repeat = {2, 5}}), 4, 3, {2, 5}},
        {"column", make_column({.bottom_radius = 2, .top_radius = 2, .height = 3, .sides = 24, .rows = 5}), 24, 5},
        {"tapered column",
         make_column({.bottom_radius = 1, .top_radius = 0.25f, .height = 2, .sides = 16, .rows = 4, .repeat = {6, 2}}),
         16,
         4,
         {6, 2}},
        {"widening column", make_column({.bottom_radius = 0.5f, .top_radius = 2, .height = 0.25f}), 48, 8},
        {"sphere", make_sphere({.radius = 5, .sides = 48, .rows = 24, .repeat = {4, 2}}), 48, 24, {4, 2}},
        {"coarse sphere", make_sphere({.sides = 5, .rows = 4}), 5, 4},
        {"grid", make_grid({.width = 3, .depth = 7, .columns = 6, .rows = 5, .repeat = {3, 7}}), 6, 5, {3, 7}},
        {"disc",
         make_column({.bottom_radius = 2, .top_radius = 0, .height = 0, .sides = 12, .rows = 3, .repeat = {4, 1}}),
         12,
         3,
         {4, 1}},
        {"torus", make_torus({.ring_radius = 2, .tube_radius = 0.5f, .repeat = {8, 2}}), 64, 24, {8, 2}},
        {"coarse torus", make_torus({.tube_radius = 0.75f, .sides = 5, .rows = 4}), 5, 4},
    };
}

double largest_position(const Mesh& mesh) {
    double largest = 0;
    for (const Vertex& vertex : mesh.vertices) largest = std::max<double>(largest, glm::length(vertex.position));
    return largest;
}

TEST(Shapes, AreGridsWithTwoTrianglesACell) {
    for (const Grid& shape : shapes()) {
        ASSERT_EQ(shape.mesh.vertices.size(), size_t((shape.columns + 1) * (shape.rows + 1))) << shape.name;
        EXPECT_EQ(shape.mesh.indices.size(), size_t(6 * shape.columns * shape.rows)) << shape.name;
        std::vector<bool> used(shape.mesh.vertices.size());
        for (const uint32_t index : shape.mesh.indices) {
            ASSERT_LT(index, used.size()) << shape.name;
            used[index] = true;
        }
        EXPECT_EQ(std::count(used.begin(), used.end(), false), 0) << shape.name << ": a vertex is in no triangle";
    }
}

TEST(Shapes, FramesFollowTheSurface) {
    for (const Grid& shape : shapes())
        for (int row = 1; row < shape.rows; ++row)
            for (int column = 1; column < shape.columns; ++column) {
                const glm::dvec3 du = shape.along_u(column, row), dv = shape.along_v(column, row);
                const Vertex& vertex = shape.at(column, row);
                const glm::dvec3 normal(vertex.normal), tangent(vertex.tangent);
                const glm::dvec3 bitangent = double(vertex.tangent.w) * glm::cross(normal, tangent);
                // Across equal steps on a circle or a line, the chord is parallel to the tangent in its middle. The
                // remaining error is the rounding of two positions divided by their distance.
                const double step = std::min(glm::length(du), glm::length(dv));
                const double tolerance = 4e-7 * largest_position(shape.mesh) / step;
                const std::string where =
                    std::string(shape.name) + " at " + std::to_string(column) + ", " + std::to_string(row);
                EXPECT_NEAR(glm::distance(glm::normalize(glm::cross(du, dv)), normal), 0, tolerance) << where;
                EXPECT_NEAR(glm::distance(glm::normalize(du), tangent), 0, tolerance) << where << ": u grows along it";
                EXPECT_NEAR(glm::distance(glm::normalize(dv), bitangent), 0, tolerance)
                    << where << ": v grows along it";
            }
}

TEST(Shapes, UvRunFromZeroToTheRepeat) {
    for (const Grid& shape : shapes())
        for (int row = 0; row <= shape.rows; ++row)
            for (int column = 0; column <= shape.columns; ++column) {
                const glm::vec2 uv =
                    glm::vec2(float(column) / float(shape.columns), float(row) / float(shape.rows)) * shape.repeat;
                EXPECT_NEAR(glm::distance(shape.at(column, row).uv, uv), 0, 1e-6) << shape.name;
            }
}

TEST(Shapes, DuplicateSeamVerticesWithTheUvOfBothSides) {
    for (const Grid& shape : shapes()) {
        if (shape.name == std::string("quad") || shape.name == std::string("grid")) continue;
        for (int row = 0; row <= shape.rows; ++row) {
            const Vertex &first = shape.at(0, row), &last = shape.at(shape.columns, row);
            // The sine of a full turn is 2e-16 in double.
            EXPECT_LT(glm::distance(first.position, last.position), 1e-12) << shape.name << ", row " << row;
            EXPECT_LT(glm::distance(first.normal, last.normal), 1e-12) << shape.name << ", row " << row;
            EXPECT_LT(glm::distance(first.tangent, last.tangent), 1e-12) << shape.name << ", row " << row;
            EXPECT_EQ(last.uv.x - first.uv.x, shape.repeat.x) << shape.name << ", row " << row;
        }
    }
}

TEST(Shapes, ASeamIsClosedToTheLastBit) {
    const Mesh column = make_column({.sides = 7, .rows = 1}), sphere = make_sphere({.sides = 7, .rows = 4});
    for (const Mesh* mesh : {&column, &sphere})
        for (size_t row = 0; row < mesh->vertices.size(); row += 8) {
            EXPECT_EQ(mesh->vertices[row].position, mesh->vertices[row + 7].position);
            EXPECT_EQ(mesh->vertices[row].normal, mesh->vertices[row + 7].normal);
        }
}

TEST(Column, WithoutHeightAndTaperHasRadialNormals) {
    for (const Vertex& vertex : make_column({.height = 0}).vertices)
        EXPECT_NEAR(glm::dot(vertex.normal, vertex.position), 1, 1e-6);
}

TEST(Quad, FacesZAndIsCentred) {
    const Mesh quad = make_quad({.width = 4, .height = 2});
    const glm::vec3 corners[] = {{-2, -1, 0}, {2, -1, 0}, {-2, 1, 0}, {2, 1, 0}};
    ASSERT_EQ(quad.vertices.size(), 4u);
    for (size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(quad.vertices[i].position, corners[i]);
        EXPECT_EQ(quad.vertices[i].normal, glm::vec3(0, 0, 1));
        EXPECT_EQ(quad.vertices[i].tangent, glm::vec4(1, 0, 0, 1));
    }
}

TEST(Column, StandsOnTheGroundAndFacesOutwards) {
    for (const auto& [bottom, top] : {std::pair(1.0f, 1.0f), {2.0f, 0.5f}, {0.5f, 2.0f}})
        for (const Vertex& vertex : make_column({.bottom_radius = bottom, .top_radius = top, .height = 3}).vertices) {
            const float share = vertex.position.y / 3, radius = bottom + share * (top - bottom);
            EXPECT_NEAR(std::hypot(vertex.position.x, vertex.position.z), radius, 1e-6);
            EXPECT_TRUE(share >= 0 && share <= 1) << share;
            // Exact: perpendicular to the side line (top - bottom, 3) in the half plane through the axis.
            const double out = (vertex.normal.x * vertex.position.x + vertex.normal.z * vertex.position.z) / radius;
            EXPECT_NEAR(out, 3 / std::hypot(3, top - bottom), 1e-6);
            EXPECT_NEAR(vertex.normal.y, (bottom - top) / std::hypot(3, top - bottom), 1e-6);
        }
}

TEST(Sphere, HasItsNormalsAlongItsRadiiAndItsPolesOnTheAxis) {
    const Mesh sphere = make_sphere({.radius = 3, .sides = 12, .rows = 6});
    for (const Vertex& vertex : sphere.vertices) EXPECT_LT(glm::distance(vertex.position, 3.0f * vertex.normal), 1e-6f);
    EXPECT_LT(glm::distance(sphere.vertices.front().position, glm::vec3(0, -3, 0)), 1e-6f) << "v = 0 is the lower pole";
    EXPECT_LT(glm::distance(sphere.vertices.back().position, glm::vec3(0, 3, 0)), 1e-6f);
    EXPECT_LT(glm::distance(sphere.vertices[3 * 13].position, glm::vec3(0, 0, -3)), 1e-6f) << "u = 0 is at -z";
    for (int column = 0; column <= 12; ++column)  // each of a pole's vertices has the tangent of its own meridian
        EXPECT_EQ(sphere.vertices[size_t(column)].tangent, sphere.vertices[size_t(3 * 13 + column)].tangent);
}

}  // namespace
}  // namespace relief
