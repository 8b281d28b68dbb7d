// The shapes as surfaces: triangles converge to the frames of their vertices, solids are closed, areas and volumes
// converge to the closed form, and unusable parameters give valid meshes.
#include <array>
#include <cmath>
#include <functional>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <map>

#include "framework/library/mesh/shapes.h"
#include "tests/support.h"

namespace relief {
namespace {

constexpr double pi = glm::pi<double>();

struct Surface {
    const char* name;
    std::function<Mesh(int detail)> make;  ///< the size of cells is proportional to 1 / detail
    double area;
    double volume = 0;  ///< 0: not closed
};

/// Areas and volumes from the formula of each shape. A frustum of a cone has the area pi (r + R) slant.
const Surface surfaces[] = {
    {"quad",
     [](int n) {
         return make_quad({.width = 3, .height = 2, .columns = n, .rows = n, .repeat = {5, 2}});
     },
     6},
    {"grid",
     [](int n) {
         return make_grid({.width = 3, .depth = 2, .columns = n, .rows = n, .repeat = {2, 5}});
     },
     6},
    {"box",
     [](int n) {
         return make_box({.size = {1, 2, 3}, .cells = {n, 2 * n, 3 * n}, .repeat = {2, 2}});
     },
     2 * (1 * 2 + 2 * 3 + 3 * 1), 6},
    {"column",
     [](int n) {
         return make_column({.bottom_radius = 2, .top_radius = 0.5f, .height = 2, .sides = 2 * n, .rows = n});
     },
     pi * 2.5 * 2.5},
    {"disc",
     [](int n) {
         return make_column(
             {.bottom_radius = 2, .top_radius = 0, .height = 0, .sides = 2 * n, .rows = n, .repeat = {3, 2}});
     },
     pi * 4},
    {"sphere", [](int n) { return make_sphere({.radius = 2, .sides = 2 * n, .rows = n}); }, 16 * pi, 32 * pi / 3},
    {"cube sphere",
     [](int n) {
         return make_cube_sphere({.radius = 2, .cells = n, .repeat = {3, 2}});
     },
     16 * pi, 32 * pi / 3},
    {"torus",
     [](int n) {
         return make_torus({.ring_radius = 2, .tube_radius = 0.5f, .sides = 3 * n, .rows = n, .repeat = {4, 1}});
     },
     4 * pi* pi * 2 * 0.5, 2 * pi* pi * 2 * 0.25},
};

struct Triangle {
    std::array<Vertex, 3> corner;
    glm::dvec3 edge(int i) const { return glm::dvec3(corner[size_t(i)].position) - glm::dvec3(corner[0].position); }
    glm::dvec2 uv_edge(int i) const { return glm::dvec2(corner[size_t(i)].uv) - glm::dvec2(corner[0].uv); }
    glm::dvec3 area() const { return glm::cross(edge(1), edge(2)) / 2.0; }
    /// dP/du and dP/dv are solved from the two edges: edge = dP/du du + dP/dv dv.
    double uv_area() const { return uv_edge(1).x * uv_edge(2).y - uv_edge(2).x * uv_edge(1).y; }
    glm::dvec3 along_u() const { return (edge(1) * uv_edge(2).y - edge(2) * uv_edge(1).y) / uv_area(); }
    glm::dvec3 along_v() const { return (edge(2) * uv_edge(1).x - edge(1) * uv_edge(2).x) / uv_area(); }
};

std::vector<Triangle> triangles(const Mesh& mesh) {
    std::vector<Triangle> all;
    for (size_t i = 0; i < mesh.indices.size(); i += 3)
        all.push_back({{mesh.vertices.at(mesh.indices[i]), mesh.vertices.at(mesh.indices[i + 1]),
                        mesh.vertices.at(mesh.indices[i + 2])}});
    return all;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Returns the largest angle between a triangle's dP/du and the tangent, averaged over its edge of constant v. In the
/// middle of that edge, the difference quotient is exact to second order.
double largest_tangent_error(const Mesh& mesh) {
    double largest = 0;
    for (const Triangle& triangle : triangles(mesh))
        for (int i = 0; i < 3; ++i) {
            const Vertex &a = triangle.corner[size_t(i)], &b = triangle.corner[size_t((i + 1) % 3)];
            if (a.uv.y != b.uv.y || glm::distance(a.position, b.position) < 1e-9f) continue;  // coincident: at a pole
            const glm::dvec3 tangent = glm::dvec3(a.tangent) + glm::dvec3(b.tangent);
            largest = std::max(largest, angle_between(triangle.along_u(), tangent));
        }
    return largest;
}

// A float position of size 3 has an error of 1e-7, and cells are at least 3 / 32: angles are below 1e-5.
constexpr double rounding = 1e-5;

TEST(ShapeSurfaces, TrianglesConvergeToTheTangentsInSecondOrder) {
    for (const Surface& surface : surfaces) {
        const double coarse = largest_tangent_error(surface.make(8)), fine = largest_tangent_error(surface.make(16));
        EXPECT_LT(coarse, 0.05) << surface.name;
        EXPECT_TRUE(fine < coarse / 3.5 || fine < rounding) << surface.name << ": " << coarse << ", then " << fine;
    }
}

TEST(ShapeSurfaces, VGrowsToTheLeftOfUSeenFromOutside) {
    for (const Surface& surface : surfaces)
        for (const Triangle& triangle : triangles(surface.make(8))) {
            if (glm::length(triangle.area()) < 1e-9) continue;  // at a pole
            const Vertex& corner = triangle.corner[0];
            const glm::dvec3 bitangent =
                double(corner.tangent.w) * glm::cross(glm::dvec3(corner.normal), glm::dvec3(corner.tangent));
            EXPECT_GT(triangle.uv_area(), 0) << surface.name << " has a mirrored triangle";
            EXPECT_GT(glm::dot(triangle.along_v(), bitangent), 0) << surface.name;
        }
}

TEST(ShapeSurfaces, HaveUnitPerpendicularFramesThatFaceOutwards) {
    for (const Surface& surface : surfaces)
        for (const Triangle& triangle : triangles(surface.make(7)))
            for (const Vertex& vertex : triangle.corner) {
                const glm::dvec3 normal(vertex.normal), tangent(vertex.tangent);
                // Each of three components is rounded to a float: 2e-7.
                ASSERT_NEAR(glm::length(normal), 1, 2e-7) << surface.name;
                ASSERT_NEAR(glm::length(tangent), 1, 2e-7) << surface.name;
                ASSERT_NEAR(glm::dot(normal, tangent), 0, 2e-7) << surface.name;
                ASSERT_EQ(vertex.tangent.w, 1) << surface.name;
                ASSERT_GE(glm::dot(triangle.area(), normal), 0) << surface.name << ": counter-clockwise from outside";
            }
}

TEST(ShapeSurfaces, AreaAndVolumeConvergeToTheClosedForm) {
    for (const Surface& surface : surfaces) {
        const auto errors = [&](int detail) {
            glm::dvec2 sum(-surface.area, -surface.volume);
            for (const Triangle& triangle : triangles(surface.make(detail)))
                sum += glm::dvec2(
                    glm::length(triangle.area()),  // and, by the divergence theorem, a third of P . n
                    surface.volume == 0 ? 0 : glm::dot(triangle.area(), glm::dvec3(triangle.corner[0].position)) / 3);
            return glm::abs(sum) / surface.area;
        };
        const glm::dvec2 coarse = errors(8), fine = errors(16);
        // Second order: the error falls to a quarter. Positions are rounded to 6e-8 of their size.
        EXPECT_TRUE(fine.x < coarse.x / 3.5 || fine.x < 1e-6) << surface.name << ", area: " << fine.x;
        EXPECT_TRUE(fine.y < coarse.y / 3.5 || fine.y < 1e-6) << surface.name << ", volume: " << fine.y;
        EXPECT_LT(std::max(fine.x, fine.y), 0.02) << surface.name;
    }
}

/// Returns the lengths of edges without a partner in the opposite direction. Vertices of equal position count as one.
std::vector<double> open_edges(const Mesh& mesh) {
    using Point = std::array<float, 3>;
    const auto point = [](const Vertex& vertex) {
        return Point{vertex.position.x, vertex.position.y, vertex.position.z};
    };
    std::map<std::pair<Point, Point>, int> edges;
    for (const Triangle& triangle : triangles(mesh))
        for (size_t i = 0; i < 3; ++i) {
            const Point a = point(triangle.corner[i]), b = point(triangle.corner[(i + 1) % 3]);
            if (a == b) continue;
            ++edges[{a, b}], --edges[{b, a}];
        }
    std::vector<double> lengths;
    for (const auto& [edge, count] : edges)
        if (count != 0) {
            const auto& [a, b] = edge;
            lengths.push_back(std::hypot(double(a[0]) - b[0], double(a[1]) - b[1], double(a[2]) - b[2]));
        }
    return lengths;
}

TEST(ShapeSurfaces, SolidsAreClosedToTheLastBit) {
    for (const int detail : {1, 3, 7, 10})
        for (const Surface& surface : surfaces) {
            if (surface.volume == 0) continue;
            for (const double length : open_edges(surface.make(detail)))  // only around a pole of the sphere
                EXPECT_TRUE(surface.name == std::string("sphere") && length < 1e-15) << surface.name << ' ' << length;
        }
    EXPECT_EQ(open_edges(make_box({.size = {0.1f, 0.7f, 1.3f}, .cells = {3, 5, 7}})).size(), 0u);
    EXPECT_EQ(open_edges(make_quad({})).size(), 2u * 4) << "each edge of a quad is open, in both directions";
}

TEST(ShapeSurfaces, TheRepeatScalesOnlyTheUv) {
    const auto all = [](glm::vec2 repeat) {
        return std::array{make_quad({.repeat = repeat}),   make_grid({.repeat = repeat}),
                          make_box({.repeat = repeat}),    make_column({.repeat = repeat}),
                          make_sphere({.repeat = repeat}), make_cube_sphere({.repeat = repeat}),
                          make_torus({.repeat = repeat})};
    };
    const auto once = all({1, 1}), often = all({3, 0.5f});
    for (size_t shape = 0; shape < once.size(); ++shape) {
        float largest = 0;
        for (size_t i = 0; i < once[shape].vertices.size(); ++i) {
            const Vertex &a = once[shape].vertices[i], &b = often[shape].vertices[i];
            EXPECT_EQ(b.uv, a.uv * glm::vec2(3, 0.5f)) << shape;
            EXPECT_TRUE(a.position == b.position && a.normal == b.normal && a.tangent == b.tangent) << shape;
            largest = std::max({largest, a.uv.x, a.uv.y});
        }
        EXPECT_EQ(largest, 1) << shape;
    }
}

TEST(Box, HasTwentyFourCornersAndHardEdges) {
    const Mesh box = make_box({.size = {2, 4, 6}});
    ASSERT_EQ(box.vertices.size(), 24u);
    EXPECT_EQ(box.indices.size(), 36u);
    for (const Vertex& vertex : box.vertices) {
        EXPECT_EQ(glm::abs(vertex.position), glm::vec3(1, 2, 3));
        EXPECT_EQ(glm::dot(glm::abs(vertex.normal), glm::vec3(1)), 1) << "along an axis";
        EXPECT_EQ(glm::dot(vertex.normal, vertex.position), glm::dot(glm::abs(vertex.normal), glm::vec3(1, 2, 3)));
    }
    EXPECT_EQ(make_box({.cells = {1, 2, 3}}).indices.size(), 6u * 2 * (1 * 2 + 2 * 3 + 3 * 1));
}

TEST(CubeSphere, HasNoPolesAndCellsOfAlikeArea) {
    double smallest = 1, largest = 0;
    for (const Triangle& triangle : triangles(make_cube_sphere({.cells = 32}))) {
        smallest = std::min(smallest, glm::length(triangle.area()));
        largest = std::max(largest, glm::length(triangle.area()));
    }
    // The ratio is sqrt(2) for the mapping itself, and slightly different for cells of finite size.
    EXPECT_NEAR(largest / smallest, std::sqrt(2.0), 0.1);
}

TEST(ShapeSurfaces, InvalidParametersGiveFinitePositionsAndUnitFrames) {
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity(),
                    largest = std::numeric_limits<float>::max(), smallest = std::numeric_limits<float>::denorm_min();
    for (const float x : {0.0f, -1.0f, nan, infinity, largest, smallest})
        for (const int n : {0, 2, std::numeric_limits<int>::min()})
            for (const glm::vec2 repeat : {glm::vec2(1, 1), glm::vec2(x, -x)})
                for (const Mesh& mesh :
                     {make_quad({.width = x, .height = x, .columns = n, .rows = n, .repeat = repeat}),
                      make_grid({.width = x, .depth = x, .columns = n, .rows = n, .repeat = repeat}),
                      make_box({.size = {x, 1, x}, .cells = {n, 1, n}, .repeat = repeat}),
                      make_column({.bottom_radius = x, .top_radius = 1, .height = x, .sides = n, .rows = n}),
                      make_column({.bottom_radius = x, .top_radius = x, .height = x, .repeat = repeat}),
                      make_column({.bottom_radius = x, .top_radius = 0, .height = 0, .repeat = repeat}),
                      make_column({.top_radius = x}),
                      make_sphere({.radius = x, .sides = n, .rows = n, .repeat = repeat}),
                      make_cube_sphere({.radius = x, .cells = n, .repeat = repeat}),
                      make_torus({.ring_radius = x, .tube_radius = 1, .sides = n, .rows = n, .repeat = repeat}),
                      make_torus({.ring_radius = 1, .tube_radius = x, .repeat = repeat})})
                    for (const Vertex& vertex : mesh.vertices) {
                        ASSERT_TRUE(std::isfinite(glm::dot(vertex.position, vertex.position))) << x;
                        ASSERT_TRUE(std::isfinite(vertex.uv.x) && std::isfinite(vertex.uv.y)) << x;
                        ASSERT_NEAR(glm::length(vertex.normal), 1, 1e-6) << x;
                        ASSERT_NEAR(glm::length(glm::vec3(vertex.tangent)), 1, 1e-6) << x;
                        ASSERT_NEAR(glm::dot(vertex.normal, glm::vec3(vertex.tangent)), 0, 1e-6) << x;
                        ASSERT_EQ(vertex.tangent.w, 1) << x;
                    }
}

TEST(ShapeSurfaces, NegativeSizesLoseTheirSignAndTheTubeRadiusIsClamped) {
    EXPECT_EQ(make_sphere({.radius = -2}).vertices[60].position, make_sphere({.radius = 2}).vertices[60].position);
    EXPECT_EQ(make_box({.size = {1, -2, 3}}).vertices[0].position, make_box({.size = {1, 2, 3}}).vertices[0].position);
    for (const Vertex& vertex : make_torus({.ring_radius = 1, .tube_radius = 5}).vertices)
        EXPECT_LE(glm::length(vertex.position), 2.000001f);
}

TEST(ShapeSurfaces, CountsAreBounded) {
    EXPECT_EQ(make_quad({.columns = 2'000'000'000, .rows = 1}).indices.size(), 6u * 4096);
    EXPECT_EQ(make_quad({.columns = 0, .rows = -3}).indices.size(), 6u);
    EXPECT_EQ(make_column({.sides = -5, .rows = 0}).indices.size(), 6u * 3);
    EXPECT_EQ(make_sphere({.sides = 1, .rows = 1}).indices.size(), 6u * 3 * 2);
    EXPECT_EQ(make_cube_sphere({.cells = -7}).vertices.size(), 24u);
    EXPECT_EQ(make_torus({.sides = 0, .rows = 0}).indices.size(), 6u * 3 * 3);
}

}  // namespace
}  // namespace relief
