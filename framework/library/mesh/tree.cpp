#include "framework/library/mesh/tree.h"

#include <algorithm>
#include <cmath>

namespace relief {
namespace {

struct Box {
    glm::vec3 low{INFINITY}, high{-INFINITY};
    void add(const glm::vec3& place) { low = glm::min(low, place), high = glm::max(high, place); }
};

class Builder {
public:
    Builder(const Mesh& mesh, TriangleTree& tree) : mesh_(mesh), tree_(tree) {
        centres_.resize(mesh.indices.size() / 3);
        float largest = 0;
        for (uint32_t i = 0; i < centres_.size(); ++i) {
            glm::vec3 sum(0);
            for (uint32_t corner = 0; corner < 3; ++corner) sum += position(i, corner) / 3.0f;
            if (!std::isfinite(sum.x + sum.y + sum.z)) continue;
            for (uint32_t corner = 0; corner < 3; ++corner)
                for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(position(i, corner)[axis]));
            centres_[i] = sum, tree.triangles.push_back(i);
        }
        margin_ = 1e-6f * largest;
        if (!tree.triangles.empty()) build(0, uint32_t(tree.triangles.size()));
    }

private:
    glm::vec3 position(uint32_t triangle, uint32_t corner) const {
        return mesh_.vertices[mesh_.indices[triangle * 3 + corner]].position;
    }

    void build(uint32_t begin, uint32_t end) {
        const auto triangles = tree_.triangles.begin();
        Box box, centres;
        for (uint32_t i = begin; i < end; ++i) {
            centres.add(centres_[triangles[i]]);
            for (uint32_t corner = 0; corner < 3; ++corner) box.add(position(triangles[i], corner));
        }
        const size_t node = tree_.nodes.size();
        tree_.nodes.push_back({box.low - margin_, box.high + margin_, 0});
        if (end - begin <= TriangleTree::leaf_triangles) {
            tree_.nodes[node].first = begin, tree_.nodes[node].count = end - begin;
        } else {
            const glm::vec3 extent = centres.high - centres.low;
            const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
            const uint32_t middle = (begin + end) / 2;
            // Break ties by the index, so that the tree does not depend on the library's selection algorithm.
            std::nth_element(triangles + begin, triangles + middle, triangles + end, [&](uint32_t a, uint32_t b) {
                const float at_a = centres_[a][axis], at_b = centres_[b][axis];
                return at_a < at_b || (at_a == at_b && a < b);
            });
            build(begin, middle), build(middle, end);
        }
        tree_.nodes[node].skip = uint32_t(tree_.nodes.size());
    }

    const Mesh& mesh_;
    TriangleTree& tree_;
    std::vector<glm::vec3> centres_;
    float margin_ = 0;
};

}  // namespace

TriangleTree build_tree(const Mesh& mesh) {
    TriangleTree tree;
    const Builder builder(mesh, tree);
    return tree;
}

}  // namespace relief
