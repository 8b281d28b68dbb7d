// The tree over a mesh's triangles.
#include "framework/library/mesh/tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

TEST(TriangleTree, ContainsEachTriangleOnceInsideEveryParentBox) {
    for (const Mesh& mesh : {make_torus({}), make_box({}), make_quad({})}) {
        const TriangleTree tree = build_tree(mesh);
        std::vector<int> seen(mesh.indices.size() / 3);
        for (size_t i = 0; i < tree.nodes.size(); ++i) {
            const TreeNode& node = tree.nodes[i];
            EXPECT_LE(node.count, TriangleTree::leaf_triangles);
            ASSERT_GT(node.skip, i);
            for (size_t below = i; below < node.skip; ++below)
                for (uint32_t k = 0; k < tree.nodes[below].count; ++k) {
                    const uint32_t triangle = tree.triangles[tree.nodes[below].first + k];
                    seen[triangle] += below == i;
                    for (uint32_t corner = 0; corner < 3; ++corner) {
                        const glm::vec3 at = mesh.vertices[mesh.indices[triangle * 3 + corner]].position;
                        EXPECT_TRUE(glm::all(glm::lessThan(node.low, at)) && glm::all(glm::lessThan(at, node.high)));
                    }
                }
        }
        EXPECT_EQ(tree.nodes.front().skip, tree.nodes.size());
        EXPECT_EQ(seen, std::vector<int>(seen.size(), 1));
    }
}

TEST(TriangleTree, IsShallow) {
    const TriangleTree tree = build_tree(make_torus({.sides = 128, .rows = 64}));  // 2^14 triangles, 4 in a leaf
    EXPECT_EQ(tree.triangles.size(), 16384u);
    EXPECT_EQ(tree.nodes.size(), 2u * 4096 - 1);
}

TEST(TriangleTree, IsEmptyForAnEmptyMeshAndOmitsNonFiniteTriangles) {
    EXPECT_TRUE(build_tree({}).nodes.empty());
    Mesh mesh = make_quad({});
    mesh.vertices[mesh.indices[0]].position.x = NAN;
    const TriangleTree tree = build_tree(mesh);
    for (const uint32_t triangle : tree.triangles)
        for (uint32_t corner = 0; corner < 3; ++corner) EXPECT_NE(mesh.indices[triangle * 3 + corner], mesh.indices[0]);
    EXPECT_LT(tree.triangles.size(), mesh.indices.size() / 3);
}

}  // namespace
}  // namespace relief
