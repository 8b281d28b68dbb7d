// MikkTSpace's semantics: the slow twin at corners computed by hand, then the fast implementation against the twin.
#include "framework/staff/reference/mikktspace.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "framework/library/mesh/shapes.h"
#include "framework/library/mesh/tangents.h"
#include "framework/staff/reference/degrees.h"
#include "tests/library/mesh/test_meshes.h"

namespace relief {
namespace {

void expect_tangent(const glm::dvec4& tangent, const glm::dvec3& along, double handedness) {
    EXPECT_LT(degrees_between(glm::dvec3(tangent), along), 1e-6) << tangent.x << " " << tangent.y << " " << tangent.z;
    EXPECT_EQ(tangent.w, handedness);
}

TEST(MikkTSpace, EqualsDpDuOnOneTriangle) {
    Mesh mesh{{flat_vertex({0, 0}, {0, 0}), flat_vertex({2, 0}, {1, 0}), flat_vertex({0, 2}, {0, 1})}, {0, 1, 2}};
    for (const glm::dvec4& t : mikktspace_reference(mesh)) expect_tangent(t, {1, 0, 0}, 1);
    // u along y, v along -x: a quarter turn.
    mesh.vertices[1].uv = {0, -1}, mesh.vertices[2].uv = {1, 0};
    for (const glm::dvec4& t : mikktspace_reference(mesh)) expect_tangent(t, {0, 1, 0}, 1);
    // u along -x: mirrored, and B = -cross(N, T) still points along v.
    mesh.vertices[1].uv = {-1, 0}, mesh.vertices[2].uv = {0, 1};
    for (const glm::dvec4& t : mikktspace_reference(mesh)) expect_tangent(t, {-1, 0, 0}, -1);
}

TEST(MikkTSpace, ProjectsOntoThePlaneOfEachCornersNormal) {
    Mesh mesh{{flat_vertex({0, 0}, {0, 0}), flat_vertex({2, 0}, {1, 0}), flat_vertex({0, 2}, {0, 1})}, {0, 1, 2}};
    mesh.vertices[1].normal = glm::normalize(glm::vec3(1, 0, 1));
    const auto tangents = mikktspace_reference(mesh);
    expect_tangent(tangents[0], {1, 0, 0}, 1);
    // The normal is a float, so a tolerance of 1e-6 degrees would be too small.
    EXPECT_LT(degrees_between(glm::dvec3(tangents[1]), {1, 0, -1}), 1e-5);
}

TEST(MikkTSpace, WeighsByTheAnglesAtTheVertex) {
    // Two triangles at the origin that share the edge to (1, 1): 45 degrees with dP/du along x, and 90 along y.
    const Mesh mesh{{flat_vertex({0, 0}, {0, 0}), flat_vertex({1, 0}, {1, 0}), flat_vertex({1, 1}, {1, 1}),
                     flat_vertex({-1, 1}, {1, 2})},
                    {0, 1, 2, 0, 2, 3}};
    // The second: uv (1, 1) at (1, 1) and (1, 2) at (-1, 1), so dP/dv = (-2, 0), and dP/du = (3, 1).
    const glm::dvec3 first(1, 0, 0), second = glm::normalize(glm::dvec3(3, 1, 0));
    const auto tangents = mikktspace_reference(mesh);
    expect_tangent(tangents[0], M_PI / 4 * first + M_PI / 2 * second, 1);
    expect_tangent(tangents[3], M_PI / 4 * first + M_PI / 2 * second, 1);
    expect_tangent(tangents[1], first, 1);
    expect_tangent(tangents[5], second, 1);
    // At (1, 1): 45 degrees in both.
    expect_tangent(tangents[2], first + second, 1);
}

TEST(MikkTSpace, WeighsByAnglesBetweenProjectedEdges) {
    // The shared edge rises at 60 degrees out of the tangent plane. Its projection is (1/2, 1/2), at 45 degrees as
    // before.
    Mesh mesh{{flat_vertex({0, 0}, {0, 0}), flat_vertex({1, 0}, {1, 0}), flat_vertex({0.5f, 0.5f}, {1, 1}),
               flat_vertex({-1, 1}, {1, 2})},
              {0, 1, 2, 0, 2, 3}};
    mesh.vertices[2].position.z = 1.2247449f;
    const glm::dvec3 p(0.5, 0.5, 1.2247449);
    // dP/du of the first is (1, 0, 0); of the second, dP/dv = (-1.5, 0.5, -z), dP/du = p - dP/dv.
    const glm::dvec3 second = p - (glm::dvec3(-1, 1, 0) - p);
    const auto flattened = glm::normalize(glm::dvec3(second.x, second.y, 0));
    const auto tangents = mikktspace_reference(mesh);
    EXPECT_LT(degrees_between(glm::dvec3(tangents[0]), M_PI / 4 * glm::dvec3(1, 0, 0) + M_PI / 2 * flattened), 1e-5);
}

TEST(MikkTSpace, AMirroredPairKeepsTwoTangentsAtItsSharedEdge) {
    // uv mirrored at x = 1.
    const Mesh mesh{{flat_vertex({0, 0}, {0, 0}), flat_vertex({1, 0}, {1, 0}), flat_vertex({1, 1}, {1, 1}),
                     flat_vertex({2, 0}, {0, 0})},
                    {0, 1, 2, 1, 3, 2}};
    const auto tangents = mikktspace_reference(mesh);
    for (int i = 0; i < 3; ++i) expect_tangent(tangents[size_t(i)], {1, 0, 0}, 1);
    for (int i = 3; i < 6; ++i) expect_tangent(tangents[size_t(i)], {-1, 0, 0}, -1);
}

TEST(MikkTSpace, TwoFansThatShareOnlyAVertexFormTwoGroups) {
    // Opposite triangles at the origin, u along x in one and along y in the other; the uv of the vertex is the same.
    const Mesh mesh{{flat_vertex({0, 0}, {0, 0}), flat_vertex({1, 0}, {1, 0}), flat_vertex({0, 1}, {0, 1}),
                     flat_vertex({-1, 0}, {0, 1}), flat_vertex({0, -1}, {-1, 0})},
                    {0, 1, 2, 0, 3, 4}};
    const auto tangents = mikktspace_reference(mesh);
    expect_tangent(tangents[0], {1, 0, 0}, 1);
    expect_tangent(tangents[3], {0, 1, 0}, 1);
}

TEST(MikkTSpace, ADegenerateUvTriangleTakesItsNeighboursTangent) {
    // The second triangle's uv lie on a line.
    const Mesh mesh{{flat_vertex({0, 0}, {0, 0}), flat_vertex({1, 0}, {1, 0}), flat_vertex({0, 1}, {0, 1}),
                     flat_vertex({1, 1}, {1, 0})},
                    {0, 1, 2, 1, 3, 2}};
    const auto tangents = mikktspace_reference(mesh);
    expect_tangent(tangents[3], {1, 0, 0}, 1);
    expect_tangent(tangents[5], {1, 0, 0}, 1);
    EXPECT_EQ(glm::dvec3(tangents[4]), glm::dvec3(0)) << "nobody there to take it from";
}

TEST(MikkTSpace, ADegenerateUvTriangleTakesTheHandednessOfItsFirstGroup) {
    // Three quads in a row. The mirror line runs through the middle one, and groups from both sides reach both of its
    // triangles.
    Mesh mesh = mirrored_grid(3, 1);
    auto tangents = mikktspace_reference(mesh);
    for (size_t i = 6; i < 12; ++i) EXPECT_EQ(tangents[i].w, -1) << "the left one's, corner " << i;
    std::rotate(mesh.indices.begin(), mesh.indices.begin() + 12, mesh.indices.end());
    tangents = mikktspace_reference(mesh);
    for (size_t i = 12; i < 18; ++i) EXPECT_EQ(tangents[i].w, 1) << "the right one's, corner " << i;
}

TEST(MikkTSpace, ATriangleWithTwoEqualCornersInherits) {
    Mesh mesh{{flat_vertex({0, 0}, {0, 0}), flat_vertex({1, 0}, {1, 0}), flat_vertex({0, 1}, {0, 1}),
               flat_vertex({1, 0}, {1, 0.5f})},
              {0, 1, 2, 0, 1, 3}};
    const auto tangents = mikktspace_reference(mesh);
    expect_tangent(tangents[3], {1, 0, 0}, 1);
    expect_tangent(tangents[4], {1, 0, 0}, 1);
    EXPECT_EQ(glm::dvec3(tangents[5]), glm::dvec3(0));
}

/// Expects that the fast tangents equal the twin's at every corner where the twin has one.
void expect_same(const Mesh& mesh) { expect_mikktspace(corner_tangents(mesh, TangentMethod::mikktspace), mesh); }

TEST(MikkTSpaceFast, AgreesWithTheTwinOnShapesAndAJitteredTorus) {
    expect_same(make_quad({.columns = 3, .rows = 2}));
    expect_same(make_column({.top_radius = 0.4f, .sides = 7, .rows = 2}));
    expect_same(make_sphere({.sides = 9, .rows = 5}));
    expect_same(jittered_torus(12, 8, 41));
}

TEST(MikkTSpaceFast, AgreesWithTheTwinWhenMirroredOrUnshared) {
    Mesh mesh = jittered_torus(8, 6, 42);
    for (Vertex& vertex : mesh.vertices)
        if (vertex.uv.x > 0.5f) vertex.uv.x = 1 - vertex.uv.x;
    expect_same(mesh);
    Mesh unshared;
    for (const uint32_t index : mesh.indices) {
        unshared.indices.push_back(uint32_t(unshared.vertices.size()));
        unshared.vertices.push_back(mesh.vertices[index]);
    }
    expect_same(unshared);
    EXPECT_EQ(corner_tangents(unshared, TangentMethod::mikktspace), corner_tangents(mesh, TangentMethod::mikktspace))
        << "it does not matter how vertices are shared";
}

TEST(MikkTSpaceFast, AgreesWithTheTwinOnRandomTriangles) {
    for (unsigned seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        expect_same(random_soup(seed, 4 + int(seed % 40)));
        if (HasFatalFailure()) return;
    }
}

TEST(MikkTSpaceFast, AgreesWithTheTwinOnDegenerateUv) {
    expect_same(mirrored_grid(7, 9));
    for (unsigned seed = 0; seed < 8; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const Mesh torus = torus_with_rounded_uv(seed);
        TangentReport report;
        corner_tangents(torus, TangentMethod::mikktspace, &report);
        ASSERT_GT(report.fell_back[size_t(TangentFallback::degenerate_uv)], 50u);
        expect_same(torus);
    }
}

TEST(MikkTSpaceFast, AgreesWithTheTwinAtAVertexOfManyTriangles) {
    // 40 triangles around a point, more than are compared one by one. Every seventh is mirrored, and every eleventh is
    // omitted.
    Mesh mesh;
    mesh.vertices.push_back(flat_vertex({0, 0}, {0, 0}));
    for (int i = 0; i < 40; ++i) {
        const float a = float(2 * M_PI * i / 40);
        mesh.vertices.push_back(
            flat_vertex({std::cos(a), std::sin(a)}, {std::cos(a) + 0.3f * float(i % 3), std::sin(a)}));
    }
    for (uint32_t i = 0; i < 40; ++i)
        if (i % 11) mesh.indices.insert(mesh.indices.end(), {0, i + 1, (i + 1) % 40 + 1});
    mesh.vertices[8].uv = {-0.9f, -0.4f};
    expect_same(mesh);
    for (uint32_t i = 3; i < 40; i += 5) mesh.vertices[i].uv = mesh.vertices[i + 1].uv;  // degenerate in uv
    expect_same(mesh);
}

}  // namespace
}  // namespace relief
