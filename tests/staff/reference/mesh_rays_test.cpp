// Rays against meshes in double precision: closed forms, and no gaps at edges and vertices.
#include "framework/staff/reference/mesh_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

TEST(MeshRays, HitATriangleOnItsPlane) {
    const glm::dvec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);  // counter-clockwise seen from +z
    const auto hit = [&](const Ray& ray) { return triangle_hit(ray, axes_of(ray.direction), a, b, c); };
    const glm::dvec4 front = hit({{0.25, 0.5, 3}, {0, 0, -2}});
    EXPECT_NEAR(front.x, 1.5, 1e-15);
    EXPECT_NEAR(front.y, 0.25, 1e-15);
    EXPECT_NEAR(front.z, 0.25, 1e-15);
    EXPECT_EQ(front.w, 1);
    EXPECT_EQ(hit({{0.25, 0.5, -3}, {0, 0, 1}}).w, -1) << "from behind";
    EXPECT_EQ(hit({{0.6, 0.6, 3}, {0, 0, -1}}), glm::dvec4(0)) << "beside it";
    EXPECT_EQ(hit({{-1, 0.2, 0}, {1, 0, 0}}), glm::dvec4(0)) << "along its plane";
    // The same triangle in each order of the axes, so that each axis is the longest once.
    for (int turn = 0; turn < 3; ++turn)
        for (const double side : {1.0, -1.0}) {
            const auto turned = [&](glm::dvec3 v) {
                return turn == 0 ? v : turn == 1 ? glm::dvec3(v.z, v.x, v.y) : glm::dvec3(v.y, v.z, v.x);
            };
            const Ray ray{turned({0.3, 0.3, 2 * side}), turned({-0.05, 0.02, -side})};
            const glm::dvec4 found = triangle_hit(ray, axes_of(ray.direction), turned(a), turned(b), turned(c));
            EXPECT_NEAR(found.x, 2, 1e-14);
            EXPECT_NEAR(found.z, 0.2, 1e-14) << "x = 0.3 - 2 * 0.05";
            EXPECT_EQ(found.w, side);
        }
}

/// Returns points on the edges and at the vertices of a mesh. Rounding may move them slightly into a triangle.
std::vector<glm::dvec3> places_on_edges(const Mesh& mesh, size_t count) {
    std::mt19937 random(3);
    std::uniform_real_distribution<> share(0, 1);
    std::vector<glm::dvec3> places;
    while (places.size() < count) {
        const size_t triangle = random() % (mesh.indices.size() / 3) * 3, corner = random() % 3;
        const auto at = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[triangle + i % 3]].position); };
        const double s = random() % 4 ? share(random) : 0;
        places.push_back(glm::mix(at(corner), at(corner + 1), s));
    }
    return places;
}

TEST(MeshRays, NeverEscapeAClosedMeshThroughEdgesOrVertices) {
    std::mt19937 random(5);
    for (const float size : {1.0f, 1e-6f, 1e6f}) {
        Mesh mesh = make_cube_sphere({.radius = size, .cells = 12});
        for (size_t i = mesh.indices.size() / 3; i > 1; --i)
            std::swap_ranges(&mesh.indices[(i - 1) * 3], &mesh.indices[(i - 1) * 3] + 3,
                             &mesh.indices[random() % i * 3]);
        const TriangleTree tree = build_tree(mesh);
        std::uniform_real_distribution<> inside(-0.4 * size, 0.4 * size);
        size_t lost = 0;
        for (const glm::dvec3& place : places_on_edges(mesh, 30000)) {
            const glm::dvec3 origin(inside(random), inside(random), inside(random));
            const auto hit = first_hit(tree, mesh, {origin, place - origin}, 2);
            lost += !hit || std::abs(hit->t - 1) > 1e-9;
        }
        EXPECT_EQ(lost, 0u) << size;
    }
}

TEST(MeshRays, FindTheSameHitsAsBruteForce) {
    const Mesh mesh = make_torus({.sides = 24, .rows = 12});
    const TriangleTree tree = build_tree(mesh);
    std::mt19937 random(9);
    std::uniform_real_distribution<> coordinate(-1.5, 1.5);
    const auto point = [&] { return glm::dvec3(coordinate(random), coordinate(random), coordinate(random)); };
    size_t total = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray{point(), point()};
        const double end = i % 2 ? 0.5 : 4;
        size_t found = 0, all = 0;
        double first = INFINITY, first_front = INFINITY;
        each_hit(tree, mesh, ray, end, [&](const MeshHit&) { ++found; });
        for (size_t k = 0; k < mesh.indices.size(); k += 3) {
            const auto at = [&](size_t corner) { return glm::dvec3(mesh.vertices[mesh.indices[k + corner]].position); };
            const glm::dvec4 hit = triangle_hit(ray, axes_of(ray.direction), at(0), at(1), at(2));
            if (hit.w == 0 || hit.x < 0 || hit.x > end) continue;
            ++all, first = std::min(first, hit.x);
            if (hit.w > 0) first_front = std::min(first_front, hit.x);
        }
        EXPECT_EQ(found, all);
        const auto distance = [](const std::optional<MeshHit>& hit) { return hit ? hit->t : INFINITY; };
        EXPECT_EQ(distance(first_hit(tree, mesh, ray, end)), first);
        EXPECT_EQ(distance(first_hit(tree, mesh, ray, end, true)), first_front);
        total += all;
    }
    EXPECT_GT(total, 300u);
}

TEST(MeshRays, FirstHitOfASphereIsItsRadiusAwayAndItsNormalPointsBack) {
    const Mesh mesh = make_cube_sphere({.radius = 2, .cells = 64});
    const TriangleTree tree = build_tree(mesh);
    for (const glm::dvec3 direction : {glm::dvec3(1, 0.2, 0.1), glm::dvec3(-0.3, 1, 0.7), glm::dvec3(0, 0, -1)}) {
        const glm::dvec3 unit = glm::normalize(direction);
        const auto hit = first_hit(tree, mesh, {5.0 * unit, -unit}, 10);
        ASSERT_TRUE(hit);
        EXPECT_TRUE(hit->is_front);
        EXPECT_NEAR(hit->t, 3, 2 * 2e-4) << "a chord of 90 / 64 degrees is 1.5e-4 of the radius within the circle";
        EXPECT_GT(glm::dot(normal_at(mesh, *hit), unit), 1 - 1e-8);
    }
    EXPECT_FALSE(first_hit(tree, mesh, {{5, 0, 0}, {-1, 0, 0}}, 2.9)) << "beyond the end";
}

}  // namespace
}  // namespace relief
