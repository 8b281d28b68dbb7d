// A tree of boxes over the triangles of a mesh, so that a ray looks at few of them.
#pragma once

#include "framework/mesh/mesh.h"

namespace relief {

/// A box around the triangles below it. Nodes lie in the order in which a walk without a stack meets them: the next
/// node is the first child; a ray that misses the box goes on at `skip`.
struct TreeNode {
    glm::vec3 low, high;
    uint32_t skip;
    uint32_t first = 0, count = 0;  ///< of TriangleTree::triangles; count is 0 but for a leaf
};

struct TriangleTree {
    static constexpr uint32_t leaf_triangles = 4;  ///< in a leaf, at most
    std::vector<TreeNode> nodes;                   ///< none where the mesh has no triangle
    std::vector<uint32_t> triangles;               ///< in the leaves' order: each triangle of the mesh once
};

/// Halves the triangles at the median of their centres, along the longest axis of these. Boxes are larger than what is
/// in them by a millionth of the mesh's largest coordinate, so that a ray in single precision misses no triangle that
/// it hits. A triangle with a position that is not finite is left out.
TriangleTree build_tree(const Mesh& mesh);

}  // namespace relief
