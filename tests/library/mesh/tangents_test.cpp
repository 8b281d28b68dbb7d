// Tangents: usable for any mesh, split where necessary, and as accurate as their weights allow.
#include "framework/library/mesh/tangents.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "framework/core/base/error.h"
#include "framework/library/mesh/shapes.h"
#include "framework/library/mesh/tangent_faces.h"
#include "framework/staff/reference/degrees.h"
#include "tests/library/mesh/test_meshes.h"
#include "tests/support.h"

namespace relief {

static void PrintTo(TangentMethod method, std::ostream* stream) {
    *stream << std::array{"per_face", "uniform", "area", "angle", "mikktspace"}[size_t(method)];
}

namespace {

using M = TangentMethod;
constexpr M methods[] = {M::per_face, M::uniform, M::area, M::angle, M::mikktspace};

Mesh triangle() {
    return {{flat_vertex({0, 0}, {0, 0}), flat_vertex({1, 0}, {1, 0}), flat_vertex({0, 1}, {0, 1})}, {0, 1, 2}};
}

/// Expects that every frame of the mesh is finite, unit and orthogonal within 1e-6, and that its handedness is 1 or -1.
void expect_usable(const Mesh& mesh) {
    for (const uint32_t index : mesh.indices) {
        const Vertex& vertex = mesh.vertices[index];
        const glm::dvec3 n(vertex.normal), t(vertex.tangent);
        ASSERT_NEAR(glm::length(n), 1, 1e-6) << index;
        ASSERT_NEAR(glm::length(t), 1, 1e-6) << index;
        ASSERT_NEAR(glm::dot(n, t), 0, 1e-6) << index;
        ASSERT_EQ(std::abs(vertex.tangent.w), 1) << index;
    }
}

void expect_all_usable(const Mesh& mesh) {
    for (const M method : methods) {
        SCOPED_TRACE(testing::PrintToString(method));
        TangentReport report;
        expect_usable(with_tangents(mesh, method, &report));
        EXPECT_EQ(report.corners, mesh.indices.size());
        EXPECT_LE(report.total(), report.corners);
        EXPECT_LE(report.inherited, report.total());
    }
}

size_t fell_back(const TangentReport& report, TangentFallback why) { return report.fell_back[size_t(why)]; }

TangentReport report_of(const Mesh& mesh, M method = M::mikktspace) {
    TangentReport report;
    corner_tangents(mesh, method, &report);
    return report;
}

TEST(Tangents, OfATriangleEqualDpDuForEveryMethod) {
    for (const M method : methods)
        for (const glm::vec4& t : corner_tangents(triangle(), method)) EXPECT_EQ(t, glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(report_of(triangle()).text(), "3 corners, none fell back");
    EXPECT_TRUE(corner_tangents({}, M::angle).empty());
}

TEST(Tangents, OfAShapeMatchTheAnalyticOnesAndSplitNoVertex) {
    for (const Mesh& mesh : {make_quad({.columns = 4, .rows = 3}), make_column({.sides = 64, .rows = 6})})
        for (const M method : {M::uniform, M::area, M::angle, M::mikktspace}) {
            const Mesh solved = with_tangents(mesh, method);
            EXPECT_EQ(solved.vertices.size(), mesh.vertices.size());
            EXPECT_EQ(solved.indices, mesh.indices);
            for (size_t i = 0; i < mesh.vertices.size(); ++i) {
                // Inside a fan, the errors of the chords' directions cancel. At the seam the error is half the angle of
                // a side, 2.8 degrees.
                EXPECT_LT(degrees_between(solved.vertices[i].tangent, mesh.vertices[i].tangent), 2.9);
                EXPECT_EQ(solved.vertices[i].tangent.w, 1);
            }
        }
}

TEST(Tangents, PerFaceSplitEachVertexBetweenFacets) {
    const Mesh roof = jittered_torus(6, 5, 50);
    const Mesh solved = with_tangents(roof, M::per_face);
    expect_usable(solved);
    EXPECT_GT(solved.vertices.size(), roof.vertices.size());
    for (size_t i = 0; i < roof.indices.size(); ++i)  // a split vertex differs only in its tangent
        EXPECT_EQ(solved.vertices[solved.indices[i]].position, roof.vertices[roof.indices[i]].position);
}

TEST(Tangents, OfAMirroredPairSplitTheirSharedEdge) {
    const Mesh pair{{flat_vertex({0, 0}, {0, 0}), flat_vertex({1, 0}, {1, 0}), flat_vertex({1, 1}, {1, 1}),
                     flat_vertex({2, 0}, {0, 0})},
                    {0, 1, 2, 1, 3, 2}};
    for (const M method : methods) {
        const Mesh solved = with_tangents(pair, method);
        EXPECT_EQ(solved.vertices.size(), 6u) << "two of four are needed twice";
        for (int i = 0; i < 6; ++i)
            EXPECT_EQ(solved.vertices[solved.indices[size_t(i)]].tangent,
                      i < 3 ? glm::vec4(1, 0, 0, 1) : glm::vec4(-1, 0, 0, -1));
    }
}

TEST(Tangents, HandednessMakesTheBitangentRunAlongV) {
    Mesh torus = jittered_torus(10, 8, 51);
    for (Vertex& vertex : torus.vertices) vertex.uv.y = -vertex.uv.y;
    for (const M method : methods)
        for (const glm::vec4& t : corner_tangents(torus, method)) EXPECT_EQ(t.w, -1);
}

TEST(Tangents, OfAFlatQuadWithFlippedUvKeepTwoHandednesses) {
    Mesh quad = make_quad({});
    quad.vertices[3].uv = {0.8f, -0.3f};  // mirrors the uv of the first triangle
    expect_all_usable(quad);
    const auto tangents = corner_tangents(quad, M::angle);
    for (int i = 0; i < 6; ++i) EXPECT_EQ(tangents[size_t(i)].w, i < 3 ? -1 : 1);
}

TEST(Tangents, OfATriangleShareOneHandednessForAnyUv) {
    std::vector<Mesh> meshes = {mirrored_grid(7, 101), mirrored_grid(1, 5)};
    for (unsigned seed = 0; seed < 20; ++seed) meshes.push_back(torus_with_rounded_uv(seed));
    for (unsigned seed = 0; seed < 60; ++seed) meshes.push_back(random_soup(seed, 30));
    for (size_t which = 0; which < meshes.size(); ++which)
        for (const M method : methods) {
            SCOPED_TRACE(testing::Message() << "mesh " << which << ", " << testing::PrintToString(method));
            const Mesh& mesh = meshes[which];
            const auto tangents = corner_tangents(mesh, method);
            size_t mixed = 0;
            for (size_t i = 0; i < tangents.size(); i += 3) {
                glm::vec3 at[3];
                for (size_t k = 0; k < 3; ++k) at[k] = mesh.vertices[mesh.indices[i + k]].position;
                if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;  // degenerate and invisible
                mixed += tangents[i].w != tangents[i + 1].w || tangents[i].w != tangents[i + 2].w;
            }
            EXPECT_EQ(mixed, 0u);
            expect_usable(with_tangents(mesh, method));
        }
}

TEST(Tangents, OfDegenerateUvFallBackAndAreReported) {
    Mesh mesh = triangle();
    for (Vertex& vertex : mesh.vertices) vertex.uv = {0.5f, 0.25f};
    EXPECT_EQ(fell_back(report_of(mesh), TangentFallback::degenerate_uv), 3u);
    expect_all_usable(mesh);
    for (Vertex& vertex : mesh.vertices) vertex.uv = glm::vec2(vertex.position.x);  // collinear
    EXPECT_EQ(fell_back(report_of(mesh), TangentFallback::degenerate_uv), 3u);
    expect_all_usable(mesh);
}

TEST(Tangents, OfDegenerateTrianglesFallBackAndAreReported) {
    Mesh mesh = triangle();
    mesh.vertices[2].position = mesh.vertices[1].position;
    EXPECT_EQ(fell_back(report_of(mesh), TangentFallback::zero_area), 3u);
    EXPECT_TRUE(contains(report_of(mesh).text(), "3 of 3 corners fell back: 3 zero area"));
    expect_all_usable(mesh);
    for (Vertex& vertex : mesh.vertices) vertex.position = {1, 2, 3};
    expect_all_usable(mesh);
    mesh = triangle();
    mesh.vertices[2].position = {2, 0, 0};  // collinear: dP/du still exists
    expect_all_usable(mesh);
}

TEST(Tangents, ParallelToTheNormalFallBackAndAreReported) {
    Mesh mesh = triangle();
    for (Vertex& vertex : mesh.vertices) vertex.normal = {1, 0, 0};
    EXPECT_EQ(fell_back(report_of(mesh), TangentFallback::parallel_to_normal), 3u);
    expect_all_usable(mesh);
    for (const float lean : {1e-3f, 1e-4f, 1e-5f, 1e-7f}) {  // nearly
        for (Vertex& vertex : mesh.vertices) vertex.normal = glm::normalize(glm::vec3(1, lean, lean));
        expect_all_usable(mesh);
    }
}

TEST(Tangents, NearlyParallelToTheNormalStillEqualDpDu) {
    Mesh mesh = triangle();
    for (const float lean : {1e-3f, 1e-4f, 1e-5f, 1e-6f})
        for (const M method : {M::per_face, M::uniform, M::area, M::angle, M::mikktspace}) {
            for (Vertex& vertex : mesh.vertices) vertex.normal = glm::normalize(glm::vec3(1, lean, 2 * lean));
            const glm::dvec3 n = glm::normalize(glm::dvec3(mesh.vertices[0].normal)), along(1, 0, 0);
            const glm::dvec3 exact = glm::normalize(along - n * glm::dot(n, along));
            // Here dP/du is exact, and the normal is given. Only the rounding of the result to floats remains.
            for (const glm::vec4& tangent : corner_tangents(mesh, method))
                EXPECT_GT(glm::dot(glm::dvec3(tangent), exact), 1 - 1e-6) << lean;
        }
}

TEST(Tangents, WithBadNormalsUseTheFaceNormal) {
    for (const glm::vec3 bad : {glm::vec3(0), glm::vec3(NAN, 0, 1), glm::vec3(0, INFINITY, 0)}) {
        Mesh mesh = triangle();
        for (Vertex& vertex : mesh.vertices) vertex.normal = bad;
        EXPECT_EQ(fell_back(report_of(mesh), TangentFallback::bad_normal), 3u);
        expect_all_usable(mesh);
        EXPECT_EQ(with_tangents(mesh, M::angle).vertices[0].normal, glm::vec3(0, 0, 1));
    }
    Mesh longer = triangle();
    for (Vertex& vertex : longer.vertices) vertex.normal = {0, 0, 1e-30f};
    EXPECT_EQ(report_of(longer).total(), 0u) << "a length is not a direction";
    expect_all_usable(longer);
}

TEST(Tangents, AreInheritedFromANeighbourIfDegenerate) {
    Mesh mesh = triangle();
    mesh.vertices.push_back(flat_vertex({1, 1}, {1, 0}));  // degenerate in uv with vertices 1 and 2
    mesh.vertices[2].uv = {0, 1};
    mesh.indices.insert(mesh.indices.end(), {1, 3, 2});
    mesh.vertices[3].uv = {0.5f, 0.5f};
    const TangentReport report = report_of(mesh, M::angle);
    EXPECT_EQ(report.total(), 3u);
    EXPECT_EQ(report.inherited, 2u);
    EXPECT_EQ(corner_tangents(mesh, M::angle)[3], glm::vec4(1, 0, 0, 1));
}

TEST(Tangents, ANanInOneVertexSpoilsNoOther) {
    for (const float bad : {NAN, INFINITY, -INFINITY})
        for (int what = 0; what < 3; ++what) {
            Mesh torus = jittered_torus(10, 8, 52);
            const auto before = corner_tangents(torus, M::mikktspace);
            Vertex& vertex = torus.vertices[37];
            if (what == 0) vertex.position.y = bad;
            if (what == 1) vertex.uv.x = bad;
            if (what == 2) vertex.normal.z = bad;
            expect_all_usable(torus);
            const auto after = corner_tangents(torus, M::mikktspace);
            size_t changed = 0;
            for (size_t i = 0; i < before.size(); ++i) changed += before[i] != after[i];
            EXPECT_LT(changed, 60u) << "more than what touches it";
        }
}

TEST(Tangents, OfATriangleWithANonFiniteVertexShareOneHandedness) {
    const auto number = [](Vertex& vertex, int which) -> float& {
        return which < 3 ? vertex.position[which] : which < 5 ? vertex.uv[which - 3] : vertex.normal[which - 5];
    };
    for (const M method : methods)
        for (const float bad : {NAN, INFINITY, -INFINITY})
            for (int which = 0; which < 8; ++which)
                for (size_t vertex = 0; vertex < 9; ++vertex) {
                    Mesh mesh = mirrored_grid(2, 2);
                    number(mesh.vertices[vertex], which) = bad;
                    const auto tangents = corner_tangents(mesh, method);
                    for (size_t i = 0; i < tangents.size(); i += 3)
                        ASSERT_TRUE(tangents[i].w == tangents[i + 1].w && tangents[i].w == tangents[i + 2].w)
                            << testing::PrintToString(method) << ", " << bad << " as number " << which << " of vertex "
                            << vertex << ": " << tangents[i].w << tangents[i + 1].w << tangents[i + 2].w;
                }
}

TEST(Tangents, DoNotDependOnTheScaleOfPositionsAndUv) {
    const Mesh torus = jittered_torus(8, 6, 53);
    for (const M method : methods) {
        const auto plain = corner_tangents(torus, method);
        for (const int exponent : {-60, -20, 20, 60}) {
            Mesh large = torus, wide = torus;
            for (Vertex& vertex : large.vertices) vertex.position *= std::ldexp(1.0f, exponent);
            for (Vertex& vertex : wide.vertices) vertex.uv *= std::ldexp(1.0f, exponent);
            EXPECT_EQ(corner_tangents(large, method), plain) << testing::PrintToString(method) << " 2^" << exponent;
            EXPECT_EQ(corner_tangents(wide, method), plain) << testing::PrintToString(method) << " 2^" << exponent;
        }
        // Powers of ten round the positions, at the ends of the range to denormals of few bits.
        for (const float scale : {1e-20f, 1e-15f, 1e-10f, 1e15f, 1e19f, 1e20f}) {
            Mesh large = torus, wide = torus;
            for (Vertex& vertex : large.vertices) vertex.position *= scale;
            for (Vertex& vertex : wide.vertices) vertex.uv *= scale;
            for (const Mesh& mesh : {large, wide}) {
                const auto scaled = corner_tangents(mesh, method);
                for (size_t i = 0; i < plain.size(); ++i)
                    ASSERT_LT(degrees_between(scaled[i], plain[i]), 0.01)
                        << testing::PrintToString(method) << " " << scale;
            }
        }
    }
    for (const float scale : {1e-44f, 1e-30f, 1e25f, 1e37f}) {
        Mesh both = torus;
        for (Vertex& vertex : both.vertices) vertex.position *= scale, vertex.uv *= scale;
        expect_all_usable(both);
    }
}

TEST(Tangents, OfRandomTrianglesAreUsable) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::mt19937 random(seed);
        Mesh soup = random_soup(seed, 30);
        // Replaces some values by extreme ones.
        const float extremes[] = {0, -0.0f, 1e-45f, 1e-38f, 1e38f, -1e38f, NAN, INFINITY};
        for (int i = 0; i < int(seed % 8); ++i) {
            Vertex& vertex = soup.vertices[random() % soup.vertices.size()];
            float* const value[] = {&vertex.position.x, &vertex.position.z, &vertex.normal.x, &vertex.normal.z,
                                    &vertex.uv.x};
            *value[random() % 5] = extremes[random() % 8];
        }
        expect_all_usable(soup);
        if (HasFatalFailure()) return;
    }
}

TEST(Tangents, OfAFanOfTenThousandTrianglesAreAccurate) {
    Mesh fan;
    fan.vertices.push_back(flat_vertex({0, 0}, {0.5f, 0.5f}));
    const uint32_t count = 10'000;
    for (uint32_t i = 0; i < count; ++i) {
        const double a = 2 * M_PI * i / count;
        fan.vertices.push_back(flat_vertex({std::cos(a), std::sin(a)}, {0.5 + std::cos(a), 0.5 + std::sin(a)}));
    }
    for (uint32_t i = 0; i < count; ++i) fan.indices.insert(fan.indices.end(), {0, i + 1, (i + 1) % count + 1});
    for (const M method : methods) {
        const Mesh solved = with_tangents(fan, method);
        expect_usable(solved);
        EXPECT_LT(degrees_between(solved.vertices[0].tangent, {1, 0, 0}), 0.1);
    }
}

TEST(Tangents, OfDuplicateTrianglesWithOppositeWindingAreUsable) {
    Mesh mesh = triangle();
    mesh.indices.insert(mesh.indices.end(), {0, 2, 1});
    expect_all_usable(mesh);
}

TEST(Tangents, AreTheSameForAnyNumberOfThreads) {
    const Mesh torus = jittered_torus(160, 120, 54);  // more than one block of work
    for (const M method : methods) {
        TangentReport one, many;
        const auto alone = corner_tangents(torus, method, &one, 1);
        for (const unsigned threads : {2u, 3u}) EXPECT_EQ(corner_tangents(torus, method, &many, threads), alone);
        EXPECT_EQ(one.text(), many.text());
    }
}

TEST(Tangents, RejectAMeshWithAWrongIndex) {
    Mesh mesh = triangle();
    mesh.indices[1] = 3;
    EXPECT_TRUE(contains(message_of([&] { corner_tangents(mesh, M::angle); }), "index 3 of a mesh with 3 vertices"));
    mesh.indices = {0, 1};
    EXPECT_TRUE(contains(message_of([&] { with_tangents(mesh, M::angle); }), "three indices"));
}

TEST(Tangents, WeightedByAngleAreClosestToDpDuOnAJitteredTorus) {
    // 4096 triangles. Known for a mesh like this: angle and MikkTSpace 0.27 degrees, uniform 0.48, area 0.66.
    const Mesh torus = jittered_torus(64, 32, 55);
    const auto error = [&](M method) {
        const auto tangents = corner_tangents(torus, method);
        double sum = 0;
        for (size_t i = 0; i < tangents.size(); ++i)
            sum += degrees_between(tangents[i], torus.vertices[torus.indices[i]].tangent);
        return sum / double(tangents.size());
    };
    const double angle = error(M::angle), uniform = error(M::uniform), area = error(M::area);
    EXPECT_LT(angle, uniform);
    EXPECT_LT(uniform, area);
    EXPECT_NEAR(error(M::mikktspace), angle, 0.05 * angle);
    EXPECT_LT(area, error(M::per_face));
}

TEST(Angles, MatchAtan2) {
    std::mt19937 random(56);
    std::uniform_real_distribution<> turn(0, M_PI), size(-70, 70);
    for (int i = 0; i < 3000; ++i) {
        double y[3], x[3], angle[3];
        for (int k = 0; k < 3; ++k) {
            angle[k] = turn(random);
            const double length = std::pow(10, size(random));
            y[k] = length * std::sin(angle[k]), x[k] = length * std::cos(angle[k]);
        }
        float measured[3];
        angles_of(y, x, measured, 3);
        for (int k = 0; k < 3; ++k) ASSERT_NEAR(measured[k], angle[k], 5e-7);
    }
    const double y[3] = {0, 0, 1}, x[3] = {0, -1, 0};
    float special[3];
    angles_of(y, x, special, 3);
    EXPECT_EQ(special[0], 0) << "0 and 0";
    EXPECT_EQ(special[1], float(M_PI));
    EXPECT_NEAR(special[2], M_PI / 2, 1e-7);
}

}  // namespace
}  // namespace relief
