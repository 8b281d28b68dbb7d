// A grid of rings: patches with different numbers of vertices meet without a gap.
#include "labs/15_ocean/polar_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <map>

namespace relief {
namespace {

TEST(PolarGrid, PatchesOfDifferentFinenessShareTheEdgesBetweenThem) {
    // Two rings of four patches. The middle circle is the finest, so that rows of each kind meet.
    const std::array<PolarCircle, 3> circles = {{{1, -3, 2}, {2, -1, 8}, {5, 2, 1}}};
    constexpr int sectors = 4;
    constexpr double width = 2 * glm::pi<double>() / sectors;
    PolarGrid grid;
    for (size_t ring = 0; ring < 2; ++ring)
        for (int i = 0; i < sectors; ++i)
            add_patch(grid, circles[ring], circles[ring + 1], width * i, width, ring == 0 ? 3 : 1);
    ASSERT_EQ(grid.indices.size() % 3, 0u);

    using Place = std::pair<float, float>;
    const auto place = [&](unsigned vertex) {
        const PolarVertex& at = grid.vertices[vertex];
        // The last patch ends where the first one begins.
        return Place(at.radius, at.angle >= float(2 * glm::pi<double>()) ? 0 : at.angle);
    };
    std::map<std::pair<Place, Place>, int> edges;
    double area = 0;
    for (size_t i = 0; i < grid.indices.size(); i += 3) {
        std::array<glm::dvec2, 3> at;
        for (size_t k = 0; k < 3; ++k) {
            ASSERT_LT(grid.indices[i + k], grid.vertices.size());
            const PolarVertex& vertex = grid.vertices[grid.indices[i + k]];
            at[k] = double(vertex.radius) * glm::dvec2(std::sin(double(vertex.angle)), std::cos(double(vertex.angle)));
            const Place a = place(grid.indices[i + k]), b = place(grid.indices[i + (k + 1) % 3]);
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
        const glm::dvec2 a = at[1] - at[0], b = at[2] - at[0];
        area += std::abs(a.x * b.y - a.y * b.x) / 2;
    }
    for (const auto& [edge, count] : edges) {
        const bool is_border =
            edge.first.first == edge.second.first && (edge.first.first == 1 || edge.first.first == 5);
        EXPECT_EQ(count, is_border ? 1 : 2) << edge.first.first << ", " << edge.first.second;
    }
    // The outer border is a square around a circle of 5, the inner one an octagon around 1.
    const double outside = 2 * 5 * 5, inside = 8 * std::sin(glm::pi<double>() / 4) / 2;
    EXPECT_NEAR(area, outside - inside, 1e-4) << "nothing is covered twice";
    for (const PolarVertex& vertex : grid.vertices)
        for (const PolarCircle& circle : circles)
            if (vertex.radius == float(circle.radius)) {
                EXPECT_EQ(vertex.detail, float(circle.detail));
            }
}

TEST(PolarGrid, EdgesAreThreeLinesForEachTriangle) {
    EXPECT_EQ(edges_of({4, 7, 9, 1, 2, 3}), std::vector<unsigned>({4, 7, 7, 9, 9, 4, 1, 2, 2, 3, 3, 1}));
    EXPECT_TRUE(edges_of({}).empty());
}

}  // namespace
}  // namespace relief
