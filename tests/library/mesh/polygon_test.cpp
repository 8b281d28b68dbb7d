// Triangulation of polygons: areas add up, no triangle is flipped, and degenerate input does no harm.
#include "framework/library/mesh/polygon.h"

#include <cmath>
#include <limits>
#include <random>

#include "framework/core/base/text.h"
#include "tests/support.h"

namespace relief {
namespace {

using Polygon = std::vector<glm::dvec3>;

std::vector<uint32_t> cut(const Polygon& polygon) {
    std::vector<uint32_t> triangles;
    triangulate(polygon, triangles);
    return triangles;
}

/// Expects corners - 2 triangles with all indices in range, and every corner used.
void expect_complete(const Polygon& polygon, const std::vector<uint32_t>& triangles) {
    ASSERT_EQ(triangles.size(), 3 * (polygon.size() - 2));
    std::vector<bool> used(polygon.size());
    for (const uint32_t i : triangles) {
        ASSERT_LT(i, polygon.size());
        used[i] = true;
    }
    for (size_t i = 0; i < used.size(); ++i) EXPECT_TRUE(used[i]) << "corner " << i << " is in no triangle";
}

/// Expects triangles with the polygon's winding and, together, its area: so they cover it exactly once.
void expect_covered(const Polygon& polygon) {
    const std::vector<uint32_t> triangles = cut(polygon);
    expect_complete(polygon, triangles);
    const glm::dvec3 whole = vector_area(polygon);
    double sum = 0;
    for (size_t i = 0; i + 2 < triangles.size(); i += 3) {
        const Polygon triangle = {polygon[triangles[i]], polygon[triangles[i + 1]], polygon[triangles[i + 2]]};
        const double area = glm::dot(vector_area(triangle), glm::normalize(whole));
        EXPECT_GE(area, -1e-12) << "triangle " << i / 3 << " is turned over";
        sum += std::abs(area);
    }
    EXPECT_NEAR(sum, glm::length(whole), 1e-12 * double(polygon.size()) * sum);
}

/// Expects the polygon in the plane z = 0 to be covered in six orientations.
void expect_covered_anywhere(const Polygon& flat) {
    for (const bool mirrored : {false, true})
        for (int axis = 0; axis < 3; ++axis) {
            SCOPED_TRACE("axis " + std::to_string(axis) + (mirrored ? ", mirrored" : ""));
            Polygon turned;
            for (const glm::dvec3& p : flat) {
                const glm::dvec3 q(mirrored ? -p.x : p.x, p.y, 0.1 * p.x + 0.2 * p.y);
                turned.push_back({q[axis], q[(axis + 1) % 3], q[(axis + 2) % 3]});
            }
            expect_covered(turned);
        }
}

TEST(VectorArea, EqualsTheAreaTimesTheNormalOfASquare) {
    EXPECT_EQ(vector_area(Polygon{{0, 0, 5}, {2, 0, 5}, {2, 2, 5}, {0, 2, 5}}), glm::dvec3(0, 0, 4));
    EXPECT_EQ(vector_area(Polygon{{0, 0, 5}, {0, 2, 5}, {2, 2, 5}, {2, 0, 5}}), glm::dvec3(0, 0, -4));
    EXPECT_EQ(vector_area(Polygon{{1, 1, 1}, {2, 2, 2}}), glm::dvec3(0));
    EXPECT_EQ(vector_area({}), glm::dvec3(0));
}

TEST(Triangulate, AQuadIsCutAlongItsShorterDiagonal) {
    EXPECT_EQ(cut({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}), (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(cut({{-3, 0, 0}, {0, -1, 0}, {3, 0, 0}, {0, 1, 0}}), (std::vector<uint32_t>{0, 1, 3, 1, 2, 3}));
}

TEST(Triangulate, CutsAConcaveQuadAtItsReflexCorner) {
    const Polygon dart = {{0, 0, 0}, {2, 2, 0}, {0, 0.5, 0}, {-2, 2, 0}};  // the longer diagonal, 1 to 3, lies outside
    for (size_t first = 0; first < 4; ++first) {
        Polygon turned;
        for (size_t i = 0; i < 4; ++i) turned.push_back(dart[(first + i) % 4]);
        expect_covered_anywhere(turned);
    }
    expect_covered_anywhere({{0, -9, 0}, {1, 1, 0}, {0, 0, 0}, {-1, 1, 0}});  // the shorter one lies outside
}

TEST(Triangulate, CoversConvexAndConcavePolygonsOnce) {
    for (const char* corners :
         {"00 20 31 22 02", "00 30 31 11 13 03",  // an L
          "00 50 53 43 41 31 33 23 21 11 13 03",  // a comb
          "00 40 44 04 00 11 13 33 31 11",        // a square with a hole, and a bridge that is traversed twice
          "00 10 20 22 12 11 01"}) {              // in line
        Polygon flat;
        for (const std::string& at : split(corners, ' ')) flat.push_back({at[0] - '0', at[1] - '0', 0});
        expect_covered_anywhere(flat);
    }
}

TEST(Triangulate, CoversStarsOfRandomRadii) {
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> radius(0.2, 2);
        Polygon star;
        const int count = 5 + int(seed) * 3;
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::acos(-1.0) * i / count, r = radius(random);
            star.push_back({r * std::cos(angle), r * std::sin(angle), 0});
        }
        expect_covered_anywhere(star);
    }
}

TEST(Triangulate, CoversAllCornersOfADegeneratePolygon) {
    const double huge = std::numeric_limits<float>::max();
    for (const Polygon& polygon : {Polygon(7, {1, 1, 1}),                                               // one point
                                   Polygon{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 1, 1}},      // a line
                                   Polygon{{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}},                 // a bow tie
                                   Polygon{{0, 3, 0}, {2, -2, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -2, 0}},  // a pentagram
                                   Polygon{{0, 0, 0}, {huge, 0, 0}, {huge, huge, 0}, {0, huge, huge}, {0, 1, 0}},
                                   Polygon{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}, {2, 1, 0}, {2, 9, 0}}})
        expect_complete(polygon, cut(polygon));
    EXPECT_TRUE(cut({}).empty());
    EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}}).empty());
}

}  // namespace
}  // namespace relief
