// Patches have the same bits for shared places, edges and directions. Triangles are joined or split into quads.
#include "framework/library/mesh/patches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <tuple>

#include "framework/library/mesh/obj.h"
#include "framework/library/mesh/shapes.h"
#include "tests/library/mesh/test_meshes.h"
#include "tests/support.h"

namespace relief {
namespace {

struct Named {
    const char* name;
    Mesh mesh;
};

Mesh urn() { return read_obj(std::string(source_folder) + "/assets/urn.obj").mesh; }

/// Returns meshes with seams, poles, hard edges and borders.
std::vector<Named> meshes() {
    return {
        {"sphere", make_sphere({.radius = 3, .sides = 12, .rows = 6, .repeat = {4, 2}})},
        {"coarse sphere", make_sphere({.sides = 3, .rows = 2})},
        {"cube sphere", make_cube_sphere({.cells = 4})},
        {"torus", make_torus({.sides = 12, .rows = 6, .repeat = {8, 2}})},
        {"box", make_box({.size = {1, 2, 3}, .cells = {1, 2, 3}})},
        {"column", make_column({.sides = 7, .rows = 2, .repeat = {2, 1}})},
        {"quad", make_quad({.columns = 3, .rows = 2})},
        {"disc", make_column({.top_radius = 0, .height = 0, .sides = 8, .rows = 2})},
        {"urn", urn()},
    };
}

/// Returns the mesh without its first triangle, so that consecutive triangles no longer form quads.
Mesh without_first_triangle(Mesh mesh) {
    mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + 3);
    return mesh;
}

using Position = std::tuple<float, float, float>;
Position key(const PatchCorner& corner) {
    return {corner.vertex.position.x, corner.vertex.position.y, corner.vertex.position.z};
}

const PatchCorner& after(const PatchMesh& patches, size_t i) {
    const size_t corners = size_t(patches.corners);
    return patches.points[i - i % corners + (i + 1) % corners];
}

/// Calls `check` with the patches of each mesh as triangles, as quads, and as quads of split triangles.
template <class Check>
void for_all(Check check) {
    for (const auto& [name, mesh] : meshes()) {
        check(make_patches(mesh, 3), std::string(name) + " in triangles");
        check(make_patches(mesh, 4), std::string(name) + " in quads");
        check(make_patches(without_first_triangle(mesh), 4), std::string(name) + ", split");
    }
}

std::vector<glm::vec3> positions(const PatchMesh& patches) {
    std::vector<glm::vec3> all;
    for (const PatchCorner& point : patches.points) all.push_back(point.vertex.position);
    return all;
}

/// Returns the outward vector area, doubled.
glm::dvec3 across(const PatchMesh& patches, size_t patch) {
    const PatchCorner* const p = &patches.points[patch * size_t(patches.corners)];
    const glm::dvec3 a(p[0].vertex.position), b(p[1].vertex.position), c(p[2].vertex.position);
    if (patches.corners == 3) return glm::cross(b - a, c - a);
    return glm::cross(c - a, glm::dvec3(p[3].vertex.position) - b);
}

TEST(Patches, OfThreeCornersAreTheNonDegenerateTriangles) {
    for (const auto& [name, mesh] : meshes()) {
        const PatchMesh patches = make_patches(mesh, 3);
        size_t at = 0;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vertex* corners[3];
            for (size_t k = 0; k < 3; ++k) corners[k] = &mesh.vertices[mesh.indices[i + k]];
            // The distance between a pole's vertices is 1e-16; between any others it is more than 0.1.
            const auto meet = [&](int k, int m) {
                return glm::distance(corners[k]->position, corners[m]->position) < 1e-6f;
            };
            if (meet(0, 1) || meet(1, 2) || meet(2, 0)) continue;
            ASSERT_LT(at, patches.points.size()) << name;
            for (const Vertex* const vertex : corners) {
                const Vertex& point = patches.points[at++].vertex;
                EXPECT_EQ(point.uv, vertex->uv) << name;
                EXPECT_EQ(point.normal, vertex->normal) << name;
                EXPECT_EQ(point.tangent, vertex->tangent) << name;
                // Coordinates up to 1e-12 of an extent of 3 have become 0.
                EXPECT_LT(glm::distance(point.position, vertex->position), 6e-12f) << name;
            }
        }
        EXPECT_EQ(at, patches.points.size()) << name;
        EXPECT_EQ(at / 3, patches.patches()) << name;
    }
    EXPECT_EQ(make_patches(make_sphere({.radius = 0}), 4).patches(), 0u) << "nor is a quad without area one";
}

TEST(Patches, OfFourCornersAreGridCellsWithUAlongTheFirstSide) {
    for (const auto& [name, mesh] : meshes()) {
        const PatchMesh patches = make_patches(mesh, 4);
        ASSERT_EQ(patches.patches(), mesh.indices.size() / 6) << name;
        for (size_t i = 0; i < patches.patches() && name != std::string("urn"); ++i) {
            const uint32_t* const cell = &mesh.indices[i * 6];  // a b d, a d c
            const uint32_t expected[] = {cell[0], cell[1], cell[2], cell[5]};
            for (size_t k = 0; k < 4; ++k)
                EXPECT_EQ(patches.points[i * 4 + k].vertex.uv, mesh.vertices[expected[k]].uv) << name << ", cell " << i;
        }
    }
}

TEST(Patches, OfFourCornersStartWithTheFirstTriangleWhicheverEdgeIsShared) {
    Mesh mesh;
    for (const glm::vec2 at : {glm::vec2(0, 0), {1, 0}, {1, 1}, {0, 1}}) mesh.vertices.push_back(flat_vertex(at, at));
    for (const auto& [first, second] :
         {std::pair<std::array<uint32_t, 3>, std::array<uint32_t, 3>>{{0, 1, 2}, {0, 2, 3}},
          {{0, 1, 3}, {1, 2, 3}},
          {{0, 2, 3}, {1, 2, 0}}}) {
        mesh.indices.assign(first.begin(), first.end());
        mesh.indices.insert(mesh.indices.end(), second.begin(), second.end());
        EXPECT_EQ(positions(make_patches(mesh, 4)),
                  (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}));
    }
}

TEST(Patches, FaceAlongTheirNormals) {
    for_all([](const PatchMesh& patches, const std::string& name) {
        for (size_t i = 0; i < patches.patches(); ++i)
            EXPECT_GT(
                glm::dot(across(patches, i), glm::dvec3(patches.points[i * size_t(patches.corners)].vertex.normal)), 0)
                << name << ", patch " << i;
    });
}

TEST(Patches, SharePositionsBitForBit) {
    for_all([](const PatchMesh& patches, const std::string& name) {
        std::map<Position, const PatchCorner*> owners;
        for (const PatchCorner& point : patches.points) {
            const PatchCorner& owner = *owners.try_emplace(key(point), &point).first->second;
            // -0 == 0, but displaced points would differ in their bits.
            for (int i = 0; i < 3; ++i)
                EXPECT_EQ(std::signbit(point.vertex.position[i]), std::signbit(owner.vertex.position[i])) << name;
            EXPECT_EQ(point.direction, owner.direction) << name;
            EXPECT_EQ(point.height_uv, owner.vertex.uv) << name << ": the first that is there owns the place";
            EXPECT_EQ(point.spacing, owner.spacing) << name;
        }
    });
}

TEST(Patches, ReadASharedEdgeAtTheFirstPatchsUv) {
    for_all([](const PatchMesh& patches, const std::string& name) {
        std::map<std::pair<Position, Position>, glm::vec4> edges;
        for (size_t i = 0; i < patches.points.size(); ++i) {
            const PatchCorner &here = patches.points[i], &there = after(patches, i);
            glm::vec4 uv(here.vertex.uv, there.vertex.uv);
            if (key(here) == key(there)) {
                EXPECT_EQ(here.edge_uv, glm::vec4(here.height_uv, here.height_uv)) << name;
                continue;
            }
            edges.try_emplace({key(there), key(here)}, uv.z, uv.w, uv.x, uv.y);
            uv = edges.try_emplace({key(here), key(there)}, uv).first->second;
            EXPECT_EQ(here.edge_uv, uv) << name << ", corner " << i;
        }
    });
}

TEST(Patches, AreClosedForSolidsAndOpenForSheets) {
    const std::set<std::string> solids = {"sphere", "coarse sphere", "cube sphere", "torus", "box"};
    for (const auto& [name, mesh] : meshes())
        for (const int corners : {3, 4})
            EXPECT_EQ(make_patches(mesh, corners).is_closed, solids.contains(name)) << name;

    Mesh torus = make_torus({.sides = 5, .rows = 4});
    EXPECT_FALSE(make_patches(without_first_triangle(torus), 3).is_closed) << "a hole";
    std::swap(torus.indices[0], torus.indices[1]);
    EXPECT_FALSE(make_patches(torus, 3).is_closed) << "one triangle is turned over";
    std::swap(torus.indices[0], torus.indices[1]);
    torus.indices.insert(torus.indices.end(), torus.indices.begin(), torus.indices.end());
    EXPECT_FALSE(make_patches(torus, 3).is_closed) << "everything twice";
}

TEST(Patches, AreDisplacedDiagonallyAtTheCornersOfAnyBox) {
    for (const int corners : {3, 4}) {
        for (const PatchCorner& point : make_patches(make_box({.size = {1, 2, 5}}), corners).points) {
            // A face's corner has one angle of 90 degrees or two of 45, so the three normals have equal weights.
            const glm::vec3 diagonal = glm::sign(point.vertex.position) / std::sqrt(3.0f);
            EXPECT_LT(glm::distance(point.direction, diagonal), 2e-7f);
        }
        // In the middle of an edge there are two normals, however many triangles have each.
        for (const PatchCorner& point : make_patches(make_box({.cells = {2, 2, 2}}), corners).points)
            EXPECT_LT(glm::distance(point.direction, glm::normalize(point.vertex.position)), 2e-7f);
    }
}

TEST(Patches, AreDisplacedAlongTheNormalsOfASmoothMeshBitForBit) {
    Mesh torus = make_torus({.sides = 12, .rows = 6});
    for (Vertex& vertex : torus.vertices) vertex.normal *= 0.99999f;  // as in a file with five digits
    for (const int corners : {3, 4}) {
        for (const PatchCorner& point : make_patches(torus, corners).points)
            EXPECT_EQ(point.direction, point.vertex.normal);
        for (const PatchCorner& point : make_patches(make_sphere({.sides = 12, .rows = 6}), corners).points)
            // The normals at a pole differ by 1e-16, and their mean is rounded.
            EXPECT_LE(glm::distance(point.direction, point.vertex.normal),
                      std::abs(point.vertex.position.y) == 1 ? 1e-6f : 0);
    }
}

TEST(Patches, KeepTheirNormalsWhereTheSumCancels) {
    Mesh sheet;  // two-sided
    for (const float side : {1.0f, -1.0f})
        for (const glm::vec2 at : {glm::vec2(0, 0), {1, 0}, {0, 1}}) {
            sheet.vertices.push_back(flat_vertex(at, at));
            sheet.vertices.back().normal.z = side;
        }
    sheet.indices = {0, 1, 2, 3, 5, 4};
    const PatchMesh patches = make_patches(sheet, 3);
    for (const PatchCorner& point : patches.points) EXPECT_EQ(point.direction, point.vertex.normal);
    EXPECT_TRUE(patches.is_closed);
}

TEST(Patches, SpacingIsTheMeanEdgeLengthAtAPosition) {
    // 2 x 1 metres in 4 x 1 cells, so cells are 0.5 x 1. uv run over 8 x 3, so cells are 2 x 3 in uv.
    const Mesh grid = make_quad({.width = 2, .height = 1, .columns = 4, .rows = 1, .repeat = {8, 3}});
    for (const PatchCorner& point : make_patches(grid, 4).points) {
        const bool is_end = std::abs(point.vertex.position.x) == 1;  // two edges meet there, elsewhere three
        EXPECT_EQ(point.spacing, is_end ? glm::vec2(1.5f / 2, 5.0f / 2) : glm::vec2(2.0f / 3, 7.0f / 3));
    }
    // At a pole, each meridian counts once and sides of zero length do not count: the chord of a quarter circle.
    const PatchMesh sphere = make_patches(make_sphere({.sides = 6, .rows = 2}), 4);
    for (const PatchCorner& point : sphere.points)
        if (std::abs(point.vertex.position.y) == 1) {
            EXPECT_NEAR(point.spacing.x, std::sqrt(2), 1e-6);
            EXPECT_NEAR(point.spacing.y, 0.5, 1e-6);
        }
}

TEST(Patches, SplitEachTriangleIntoThreeIfNotPairedAsQuads) {
    Mesh bent = make_box({});  // two of its sides, which meet at 90 degrees
    bent.indices.assign({0, 1, 2, 0, 2, 3});
    for (const glm::vec3 at : {glm::vec3(0, 0, 0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.2f, 0.2f, 0}, {5, 5, 0}}) {
        bent.vertices.push_back(flat_vertex({at.x, at.y}, {at.x, at.y}));
        bent.vertices.back().position.z = at.z;
    }
    const uint32_t a = uint32_t(bent.vertices.size()) - 6;
    const std::vector<uint32_t> folded = {a, a + 1, a + 2, a + 1, a, a + 3}, dart = {a + 4, a, a + 1, a, a + 4, a + 2},
                                apart = {a, a + 1, a + 2, a + 4, a + 5, a + 3},
                                turned = {a, a + 1, a + 2, a + 1, a + 2, a + 5}, odd = {a, a + 1, a + 2};
    for (const auto& indices : {folded, dart, apart, turned, odd}) {
        bent.indices = indices;
        EXPECT_EQ(make_patches(bent, 4).patches(), indices.size());
    }
    bent.indices = {a, a + 1, a + 2, a + 1, a + 5, a + 2};
    EXPECT_EQ(make_patches(bent, 4).patches(), 1u) << "this one is a quad";
    bent.vertices.push_back(bent.vertices[a + 1]);
    bent.vertices.back().uv += 1;
    bent.indices[3] = a + 6;
    EXPECT_EQ(make_patches(bent, 4).patches(), 6u) << "a seam along the diagonal would be lost";
}

TEST(Patches, OfASplitTriangleUseItsMidpointsAndCoverItsArea) {
    Mesh mesh;
    for (const glm::vec2 at : {glm::vec2(0, 0), {6, 0}, {0, 6}}) mesh.vertices.push_back(flat_vertex(at, at / 6.0f));
    mesh.vertices[0].normal = {1, 0, 0}, mesh.vertices[1].normal = {0, 1, 0};
    mesh.vertices[0].tangent = {0, 1, 0, -1}, mesh.vertices[1].tangent = {0, 0, 1, -1};
    mesh.vertices[2].tangent = {1, 0, 0, -1};
    mesh.indices = {0, 1, 2};
    const PatchMesh patches = make_patches(mesh, 4);
    std::string found;
    for (const glm::vec3& at : positions(patches)) found += fmt::format("{} {} {}; ", at.x, at.y, at.z);
    EXPECT_EQ(found, "0 0 0; 3 0 0; 2 2 0; 0 3 0; 6 0 0; 3 3 0; 2 2 0; 3 0 0; 0 6 0; 0 3 0; 2 2 0; 3 3 0; ");
    for (const PatchCorner& point : patches.points) {
        const glm::dvec3 normal(point.vertex.normal), tangent(point.vertex.tangent);
        EXPECT_LT(glm::distance(glm::vec2(point.vertex.position), 6.0f * point.vertex.uv), 1e-6f);
        // Each of three components is rounded to a float.
        EXPECT_NEAR(glm::length(normal), 1, 2e-7);
        EXPECT_NEAR(glm::length(tangent), 1, 2e-7);
        EXPECT_NEAR(glm::dot(normal, tangent), 0, 2e-7);
        EXPECT_EQ(point.vertex.tangent.w, -1);
    }
    EXPECT_LT(glm::distance(patches.points[1].vertex.normal, glm::normalize(glm::vec3(1, 1, 0))), 2e-7f);
    EXPECT_LT(glm::distance(patches.points[2].vertex.normal, glm::normalize(glm::vec3(1, 1, 1))), 2e-7f);
}

TEST(Patches, AreClosedForASplitSolid) {
    for (const auto& [name, mesh] : meshes()) {
        Mesh closed = mesh;  // with a degenerate triangle at the end, for an odd number of triangles
        closed.indices.insert(closed.indices.end(), 3, closed.indices[0]);
        const PatchMesh patches = make_patches(closed, 4);
        EXPECT_EQ(patches.patches(), 3 * make_patches(mesh, 3).patches()) << name;
        EXPECT_EQ(patches.is_closed, make_patches(mesh, 4).is_closed) << name;
    }
}

TEST(Patches, NonFiniteVerticesDoNotSpoilOthers) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -infinity})
        for (const int corners : {3, 4}) {
            Mesh mesh = make_torus({.sides = 5, .rows = 4});
            mesh.vertices[8].position.x = mesh.vertices[8].uv.y = bad;
            mesh.vertices[15].normal.z = bad;
            for (const PatchCorner& point : make_patches(mesh, corners).points)
                if (std::isfinite(point.vertex.position.x + point.vertex.uv.y + point.vertex.normal.z)) {
                    EXPECT_LT(glm::distance(point.direction, point.vertex.normal), 1e-6f);
                    EXPECT_TRUE(std::isfinite(point.spacing.x + point.spacing.y));
                }
            Mesh box = make_box({});
            box.vertices[0].position.x = bad;
            std::map<Position, glm::vec3> directions;
            for (const PatchCorner& point : make_patches(box, corners).points)
                if (std::isfinite(point.vertex.position.x)) {
                    EXPECT_EQ(directions.try_emplace(key(point), point.direction).first->second, point.direction);
                }
            for (Vertex& vertex : mesh.vertices) vertex.position = vertex.normal = glm::vec3(bad);
            EXPECT_NO_THROW(make_patches(mesh, corners));
        }
}

TEST(Patches, OfRandomTrianglesShareHeightUvBitForBit) {
    for (unsigned seed = 0; seed < 20; ++seed)
        for (const int corners : {3, 4}) {
            std::map<Position, const PatchCorner*> owners;
            const PatchMesh patches = make_patches(random_soup(seed, 60), corners);
            for (const PatchCorner& point : patches.points)
                EXPECT_EQ(point.height_uv, owners.try_emplace(key(point), &point).first->second->vertex.uv) << seed;
        }
}

TEST(Patches, AreEmptyForAnEmptyMesh) {
    for (const int corners : {3, 4}) EXPECT_EQ(make_patches({}, corners).patches(), 0u);
}

TEST(Patches, RequireWholeTrianglesAndThreeOrFourCorners) {
    Mesh mesh = make_quad({});
    EXPECT_TRUE(contains(message_of([&] { make_patches(mesh, 5); }), "a patch has 3 or 4 corners, not 5"));
    mesh.indices[2] = 4;
    EXPECT_TRUE(contains(message_of([&] { make_patches(mesh, 4); }), "index 4 of a mesh with 4 vertices"));
    mesh.indices.pop_back();
    EXPECT_TRUE(contains(message_of([&] { make_patches(mesh, 3); }), "three indices"));
}

}  // namespace
}  // namespace relief
