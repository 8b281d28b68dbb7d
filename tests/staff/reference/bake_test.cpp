// Baked maps against closed forms: spheres, planes, and the padding around an island.
#include "framework/staff/reference/bake.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/library/mesh/parallelogram.h"
#include "framework/library/mesh/shapes.h"
#include "framework/library/mesh/tangents.h"
#include "framework/staff/reference/degrees.h"
#include "tests/support.h"

namespace relief {
namespace {

/// Returns the place of (u, v) on a mesh of which no two triangles overlap in uv, or nothing beside its islands.
std::optional<glm::dvec3> place_of(const Mesh& mesh, glm::dvec2 uv) {
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
        const glm::dmat2 edges(glm::dvec2(b.uv) - glm::dvec2(a.uv), glm::dvec2(c.uv) - glm::dvec2(a.uv));
        if (glm::determinant(edges) == 0) continue;
        const glm::dvec2 at = glm::inverse(edges) * (uv - glm::dvec2(a.uv));
        if (at.x < 0 || at.y < 0 || at.x + at.y > 1) continue;
        return glm::dvec3(a.position) * (1 - at.x - at.y) + glm::dvec3(b.position) * at.x +
               glm::dvec3(c.position) * at.y;
    }
    return {};
}

glm::dvec3 vector_at(const Image& map, int x, int y) {
    const float* const texel = map.pixel(x, y);
    return {texel[0], texel[1], texel[2]};
}

/// A square in the plane z = 0 that covers a part of the map.
Mesh square(glm::vec2 low_uv, glm::vec2 high_uv) {
    Mesh mesh = make_quad({});
    for (Vertex& vertex : mesh.vertices) vertex.uv = low_uv + vertex.uv * (high_uv - low_uv);
    return with_tangents(mesh, TangentMethod::mikktspace);
}

/// A plane with the given slopes above `height`.
Mesh slanted(double slope_x, double slope_y, double height) {
    Mesh mesh = make_quad({.width = 3, .height = 3});
    for (Vertex& vertex : mesh.vertices) {
        vertex.position.z = float(height + slope_x * double(vertex.position.x) + slope_y * double(vertex.position.y));
        vertex.normal = glm::normalize(glm::vec3(-slope_x, -slope_y, 1));
    }
    return mesh;
}

TEST(Bake, OfASphereOnACoarserOneHasTheNormalsAndDistancesOfTheSphere) {
    constexpr double radius = 1.1;
    const Mesh fine = make_sphere({.radius = float(radius), .sides = 512, .rows = 256});
    // On a sphere of radius 1, interpolated positions and normals are the same: every ray goes to the centre.
    const Mesh coarse = with_tangents(make_sphere({.radius = 1, .sides = 12, .rows = 6}), TangentMethod::mikktspace);
    const glm::ivec2 size(96, 48);
    const auto baked = [&](BakeStore store) {
        return bake(fine, coarse, {.store = store, .size = size, .reach = 0.3});
    };
    const BakedMap object = baked(BakeStore::object), tangent = baked(BakeStore::tangent),
                   heights = baked(BakeStore::heights);
    EXPECT_EQ(object.missed, 0u);
    EXPECT_EQ(object.hit + object.filled, 96u * 48);
    EXPECT_EQ(object.covered_twice, 0u);
    double largest = 0, worst = 0, worst_tangent = 0, worst_height = 0;
    size_t covered = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const auto place = place_of(coarse, (glm::dvec2(x, size.y - 1 - y) + 0.5) / glm::dvec2(size));
            if (!place) continue;
            ++covered;
            const double height = radius - glm::length(*place);
            largest = std::max(largest, height);
            worst = std::max(worst, degrees_between(vector_at(object.values, x, y), *place));
            worst_tangent = std::max(worst_tangent, degrees_between(vector_at(tangent.values, x, y), {0, 0, 1}));
            worst_height = std::max(worst_height, std::abs(double(*heights.values.pixel(x, y)) - height));
        }
    EXPECT_EQ(object.hit, covered);
    // The fine sphere's triangles have a side of 0.7 degrees, and its interpolated normals err by far less.
    EXPECT_LT(worst, 0.01);
    EXPECT_LT(worst_tangent, 0.01) << "the normal of the coarse sphere is that of the fine one";
    // The sagitta of a fine triangle is 1.1 (1 - cos(0.35 degrees)), in both directions: 4e-5.
    EXPECT_LT(worst_height, 6e-5);
    EXPECT_NEAR(object.largest_distance, largest, 6e-5);
}

TEST(Bake, OfASlantedPlaneIsTheNormalOfItsSlopesAlsoWhereUvAreMirroredOrTurned) {
    const glm::dvec3 exact = glm::normalize(glm::dvec3(-0.2, -0.1, 1));
    const auto texel_of = [&](const Mesh& coarse) {
        const BakedMap map = bake(slanted(0.2, 0.1, 0.01), coarse, {.size = {5, 7}, .reach = 1});
        EXPECT_EQ(map.hit, 35u);
        for (int y = 0; y < 7; ++y)
            for (int x = 0; x < 5; ++x)
                EXPECT_LT(degrees_between(vector_at(map.values, x, y), vector_at(map.values, 0, 0)), 1e-4);
        return vector_at(map.values, 0, 0);
    };
    EXPECT_LT(degrees_between(texel_of(square({0, 0}, {1, 1})), exact), 1e-4);
    EXPECT_LT(degrees_between(texel_of(square({1, 0}, {0, 1})), exact * glm::dvec3(-1, 1, 1)), 1e-4) << "u mirrored";
    EXPECT_LT(degrees_between(texel_of(square({1, 1}, {0, 0})), exact * glm::dvec3(-1, -1, 1)), 1e-4) << "turned";
}

TEST(Bake, KeepsRowsAndColumnsInPlace) {
    const BakedMap map =
        bake(slanted(0.25, 0.5, 0), square({0, 0}, {1, 1}), {.store = BakeStore::heights, .size = {8, 4}, .reach = 2});
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_NEAR(*map.values.pixel(x, y), 0.25 * ((x + 0.5) / 8 - 0.5) + 0.5 * (0.5 - (y + 0.5) / 4), 1e-6);
    EXPECT_NEAR(map.largest_distance, 0.25 * 7 / 16 + 0.5 * 3 / 8, 1e-6);
}

TEST(Bake, FillsTheTexelsAroundAnIslandWithTheMeansOfTheirNeighbours) {
    // The island covers texels 2 to 5 of 8, with heights that grow by 0.1 a texel along u.
    const BakedMap map = bake(slanted(0.4, 0, 0), square({0.25f, 0.25f}, {0.75f, 0.75f}),
                              {.store = BakeStore::heights, .size = {8, 8}, .reach = 2});
    EXPECT_EQ(map.hit, 16u);
    EXPECT_EQ(map.filled, 48u);
    const auto at = [&](int x, int y) { return double(*map.values.pixel(x, y)); };
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(at(2 + i, 4), 0.1 * i - 0.15, 1e-6);
    EXPECT_NEAR(at(1, 4), -0.15, 1e-6) << "three neighbours of one height";
    EXPECT_NEAR(at(1, 1), -0.15, 1e-6) << "the corner has one neighbour";
    EXPECT_NEAR(at(3, 1), -0.05, 1e-6) << "the mean of three";
    EXPECT_NEAR(at(2, 1), -0.1, 1e-6) << "the mean of two";
    EXPECT_NEAR(at(0, 4), -0.15, 1e-6) << "the second step";
    EXPECT_NEAR(at(7, 4), 0.15, 1e-6);
}

TEST(Bake, GivesTheCoarseNormalWhereARayMisses) {
    const BakedMap map = bake(slanted(0.2, 0.1, 5), square({0, 0}, {1, 1}), {.size = {4, 4}, .reach = 0.5});
    EXPECT_EQ(map.missed, 16u);
    EXPECT_EQ(map.hit, 0u);
    EXPECT_LT(degrees_between(vector_at(map.values, 1, 2), {0, 0, 1}), 1e-5);
}

TEST(Bake, TakesTheFrontThatIsNearestToTheCoarseModelAboveItOrBelow) {
    const auto height_of = [](std::vector<Mesh> planes) {
        Mesh fine;
        for (const Mesh& plane : planes) append(fine, plane);
        const BakedMap map =
            bake(fine, square({0, 0}, {1, 1}), {.store = BakeStore::heights, .size = {3, 3}, .reach = 1});
        EXPECT_NEAR(map.largest_distance, std::abs(double(map.values.values[4])), 1e-6) << "also below";
        return double(map.values.values[4]);
    };
    const auto turned = [](Mesh plane) {
        for (size_t i = 0; i < plane.indices.size(); i += 3) std::swap(plane.indices[i], plane.indices[i + 1]);
        return plane;
    };
    EXPECT_NEAR(height_of({slanted(0, 0, 0.5), slanted(0, 0, 0.1), slanted(0, 0, -0.3)}), 0.1, 1e-6);
    EXPECT_NEAR(height_of({slanted(0, 0, 0.5), slanted(0, 0, -0.3)}), -0.3, 1e-6);
    EXPECT_NEAR(height_of({slanted(0, 0, 0.5), turned(slanted(0, 0, 0.1))}), 0.5, 1e-6) << "the nearer one is a back";
}

TEST(Bake, StoresNormalsInTheFrameAsItIsInterpolated) {
    Mesh coarse = square({0, 0}, {1, 1});
    // Normals lean apart, so that interpolated ones are shorter, and not perpendicular to the tangents.
    for (Vertex& vertex : coarse.vertices)
        vertex.normal = glm::normalize(vertex.normal + glm::vec3(vertex.uv - 0.5f, 0));
    const BakedMap map = bake(slanted(0.3, -0.2, 0), coarse, {.size = {4, 4}, .reach = 2});
    const std::vector<BakePlace> places = texel_places(coarse, {4, 4});
    const glm::dvec3 exact = glm::normalize(glm::dvec3(-0.3, 0.2, 1));
    for (int i = 0; i < 16; ++i) {
        const BakePlace& place = places[size_t(i)];
        const glm::dvec3 t(place.tangent), b = place.tangent.w * glm::cross(place.normal, t);
        const glm::dvec3 stored = vector_at(map.values, i % 4, i / 4);
        EXPECT_LT(degrees_between(stored.x * t + stored.y * b + stored.z * place.normal, exact), 1e-4);
        EXPECT_NEAR(glm::length(stored), 1, 1e-6);
    }
}

TEST(Bake, CountsTexelsThatAreCoveredTwiceAndRefusesUvBeyondTheMap) {
    Mesh twice = square({0, 0}, {1, 1});
    twice.indices.insert(twice.indices.end(), twice.indices.begin(), twice.indices.end());
    EXPECT_EQ(bake(slanted(0, 0, 0), twice, {.size = {4, 4}, .reach = 1}).covered_twice, 16u);
    const auto refusal = [](const Mesh& mesh) {
        return message_of([&] { bake(slanted(0, 0, 0), mesh, {.size = {4, 4}, .reach = 1}); });
    };
    EXPECT_EQ(refusal(square({0, 0}, {1.5f, 1})), "has the uv (1.5, 0): all of them must be in the map, from 0 to 1");
    EXPECT_TRUE(contains(refusal(square({0.5f, 0.5f}, {0.5f, 0.5f})), "covers no texel"));
}

}  // namespace
}  // namespace relief
