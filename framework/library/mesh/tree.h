// A bounding volume hierarchy over the triangles of a mesh, so that a ray tests few of them.
#pragma once

#include "framework/core/base/mesh.h"

namespace relief {

/// A bounding box of triangles. Nodes are in depth-first order, for traversal without a stack: the next node is the
/// first child, and a ray that misses the box continues at `skip`.
struct TreeNode {
    glm::vec3 low, high;
    uint32_t skip;
    uint32_t first = 0, count = 0;  ///< range of TriangleTree::triangles; count is 0 in an inner node
};

struct TriangleTree {
    static constexpr uint32_t leaf_triangles = 4;  ///< maximum number in a leaf
    std::vector<TreeNode> nodes;                   ///< empty if the mesh has no triangle
    std::vector<uint32_t> triangles;               ///< in the leaves' order: each triangle of the mesh once
};

/// Builds a tree by splitting the triangles at the median of their centres, along the longest axis of the centres.
/// Boxes are widened by a millionth of the mesh's largest coordinate. So a ray in single precision misses no triangle
/// that it hits. Drops triangles with a position that is not finite.
TriangleTree build_tree(const Mesh& mesh);

}  // namespace relief
