// A patch with skirts: a closed rim around a grid.
#include "labs/09_planet/skirted_patch.h"

#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <map>
#include <set>

namespace relief {
namespace {

/// Returns a vertex in the plane z = 0, or at z = -1 at the lower end of a skirt.
glm::dvec3 place(const SkirtedPatch& patch, int vertex) {
    const int side = patch.quads + 1, skirt = vertex - patch.grid_vertices();
    const int above = skirt < 0 ? vertex : patch.hangs_from(skirt);
    return {above % side, above / side, skirt < 0 ? 0 : -1};
}

TEST(SkirtedPatch, SkirtsCloseTheBorderAndAllTrianglesFaceOutwards) {
    for (const int quads : {1, 2, 8}) {
        const SkirtedPatch patch{quads};
        const std::vector<uint32_t> indices = patch.indices();
        ASSERT_EQ(int(indices.size()), patch.grid_indices() + 6 * 4 * quads);
        std::map<std::pair<std::array<double, 3>, std::array<double, 3>>, int> edges;
        std::set<uint32_t> used;
        const glm::dvec3 middle(quads / 2.0, quads / 2.0, -0.5);
        for (size_t i = 0; i < indices.size(); i += 3) {
            std::array<glm::dvec3, 3> corner;
            for (size_t k = 0; k < 3; ++k) {
                ASSERT_LT(int(indices[i + k]), patch.vertices());
                used.insert(indices[i + k]), corner[k] = place(patch, int(indices[i + k]));
            }
            const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
            EXPECT_EQ(glm::length(normal), 1);
            EXPECT_GT(glm::dot(normal, corner[0] - middle), 0) << i;
            EXPECT_EQ(normal.z == 1, int(i) < patch.grid_indices()) << "the grid comes first";
            for (size_t k = 0; k < 3; ++k) {
                const glm::dvec3 a = corner[k], b = corner[(k + 1) % 3];
                ++edges[{{a.x, a.y, a.z}, {b.x, b.y, b.z}}];
            }
        }
        EXPECT_EQ(int(used.size()), patch.vertices());
        // Each edge has one neighbour in the other direction, but for the lower rim.
        for (const auto& [edge, count] : edges) {
            EXPECT_EQ(count, 1);
            const bool is_rim = edge.first[2] == -1 && edge.second[2] == -1;
            EXPECT_EQ(edges.count({edge.second, edge.first}), is_rim ? 0u : 1u);
        }
    }
}

}  // namespace
}  // namespace relief
