// Surfaces against their finite differences, and rays against surfaces and meshes.
#include "framework/staff/reference/surfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

const QuadShape flat_quad{.width = 3, .height = 0.5f};
const ColumnShape column{.bottom_radius = 0.5f, .top_radius = 0.34f, .height = 2.6f};
const ColumnShape cone{.bottom_radius = 1, .top_radius = 0, .height = 2};
const ColumnShape pipe{.bottom_radius = 0.7f, .top_radius = 0.7f, .height = 1};
const SphereShape sphere{.radius = 1.3f};

template <class Test>
void for_each_shape(Test test) {
    test(flat_quad, "quad"), test(column, "column"), test(cone, "cone"), test(pipe, "pipe"), test(sphere, "sphere");
}

double distance(glm::dvec3 a, glm::dvec3 b) { return glm::length(a - b); }

TEST(Surfaces, HaveTheDerivativesOfTheirOwnPositionsAndNormals) {
    const double step = 1e-5;  // central differences are exact to 1e-8 for third derivatives below 300
    for_each_shape([&](const auto& shape, const char* name) {
        for (const glm::dvec2 at : {glm::dvec2(0.1, 0.2), glm::dvec2(0.63, 0.5), glm::dvec2(0.9, 0.85)}) {
            const SurfacePoint here = point_on(shape, at);
            const auto around = [&](glm::dvec2 way) {
                const SurfacePoint after = point_on(shape, at + step * way), before = point_on(shape, at - step * way);
                return std::pair((after.position - before.position) / (2 * step),
                                 (after.normal - before.normal) / (2 * step));
            };
            const auto [du, normal_du] = around({1, 0});
            const auto [dv, normal_dv] = around({0, 1});
            EXPECT_LT(distance(here.du, du), 1e-7) << name;
            EXPECT_LT(distance(here.dv, dv), 1e-7) << name;
            EXPECT_LT(distance(here.normal_du, normal_du), 1e-7) << name;
            EXPECT_LT(distance(here.normal_dv, normal_dv), 1e-7) << name;
            EXPECT_LT(distance(here.normal, glm::normalize(glm::cross(here.du, here.dv))), 1e-12) << name;
        }
    });
}

/// A mesh vertex is a point of its surface, rounded to floats, if the uv are repeated once.
TEST(Surfaces, MatchTheirMeshes) {
    const auto compare = [](const Mesh& mesh, const auto& shape, const char* name) {
        for (const Vertex& vertex : mesh.vertices) {
            const SurfacePoint point = point_on(shape, glm::dvec2(vertex.uv));
            EXPECT_LT(distance(point.position, vertex.position), 1e-6) << name;
            EXPECT_LT(distance(point.normal, vertex.normal), 1e-6) << name;
            if (glm::length(point.du) > 1e-6) {
                EXPECT_LT(distance(tangent_of(point), glm::vec3(vertex.tangent)), 1e-6) << name;
            }
        }
    };
    compare(make_quad(flat_quad), flat_quad, "quad");
    compare(make_column(column), column, "column");
    compare(make_sphere(sphere), sphere, "sphere");
}

TEST(Surfaces, ARayToAPointHitsThereOrEarlier) {
    const unsigned seed = 5;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    for_each_shape([&](const auto& shape, const char* name) {
        int there = 0;
        for (int i = 0; i < 500; ++i) {
            const glm::dvec2 place(between(0.01, 0.99), between(0.01, 0.99));
            const glm::dvec3 to = point_on(shape, place).position;
            const glm::dvec3 from(between(-9, 9), between(-9, 9), between(-9, 9));
            const auto hit = first_hit(shape, Ray{from, to - from});
            ASSERT_TRUE(hit) << name;
            EXPECT_LT(hit->t, 1 + 1e-9) << name;
            EXPECT_LT(distance(point_on(shape, hit->place).position, from + hit->t * (to - from)), 1e-9) << name;
            there += glm::length(hit->place - place) < 1e-6;
        }
        EXPECT_GT(there, 150) << name << ": what is in front hides the rest";
    });
}

TEST(Surfaces, AreMissedByRaysBesideAndBehind) {
    for_each_shape([](const auto& shape, const char* name) {
        EXPECT_FALSE(first_hit(shape, Ray{{9, 9, 9}, {1, 0, 0}})) << name;
        EXPECT_FALSE(first_hit(shape, Ray{{0, 0, 9}, {0, 0, 1}})) << name << ", behind";
        EXPECT_FALSE(first_hit(shape, Ray{{0, 0.2, 9}, {0, 0, 0}})) << name << ", a ray that stands still";
        EXPECT_FALSE(first_hit(shape, Ray{{NAN, 0, 9}, {0, 0, -1}})) << name;
    });
    EXPECT_FALSE(first_hit(flat_quad, Ray{{0, 0, 1}, {1, 0, 0}})) << "along the plane";
    EXPECT_FALSE(first_hit(column, Ray{{0, 5, 0}, {0, -1, 0}})) << "down through the open column";
    EXPECT_FALSE(first_hit(cone, Ray{{0.3, 3, 3}, {0, 0, -1}})) << "the other half of the double cone";
}

TEST(Surfaces, KeepTheirPrecisionFromFarAway) {
    // A sphere of 1.3 m seen from 10,000 km. The hit is exact to the rounding of that distance.
    const auto far = first_hit(sphere, Ray{{0, 0, 1e7}, {0, 0, -1}});
    ASSERT_TRUE(far);
    EXPECT_NEAR(far->t, 1e7 - double(sphere.radius), 4e-9);
    const auto pole = first_hit(pipe, Ray{{1e7, 0.5, 0}, {-1, 0, 0}});
    ASSERT_TRUE(pole);
    EXPECT_NEAR(pole->t, 1e7 - double(pipe.bottom_radius), 4e-9);
}

}  // namespace
}  // namespace relief
