#include "framework/library/mesh/gltf_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "framework/core/base/error.h"
#include "framework/library/mesh/gltf_elements.h"

namespace relief {
namespace {

glm::dmat4 parent_from_node(const GltfObject& node) {
    if (const std::vector<double> matrix = node.numbers("matrix", 16); !matrix.empty())
        return glm::make_mat4(matrix.data());
    glm::dmat4 result(1);
    if (const std::vector<double> q = node.numbers("rotation", 4); !q.empty()) {
        const glm::dquat rotation(q[3], q[0], q[1], q[2]);
        const double length = glm::length(rotation);
        if (length > 0) result = glm::mat4_cast(rotation / length);
    }
    if (const std::vector<double> scale = node.numbers("scale", 3); !scale.empty())
        for (int i = 0; i < 3; ++i) result[i] *= scale[size_t(i)];
    if (const std::vector<double> move = node.numbers("translation", 3); !move.empty())
        result[3] = glm::dvec4(glm::make_vec3(move.data()), 1);
    return result;
}

struct Nodes {
    std::vector<std::vector<int>> children;
    std::vector<int> parent;
    std::vector<glm::dmat4> world_from_node;
};

/// Throws Error for a node that has two parents, or is its own ancestor.
Nodes nodes_of(const GltfDocument& file) {
    const size_t count = file.count("nodes");
    Nodes nodes{std::vector<std::vector<int>>(count), std::vector<int>(count, -1), std::vector<glm::dmat4>(count)};
    for (size_t i = 0; i < count; ++i) {
        nodes.children[i] = file.element("nodes", int(i), "node").indices("children");
        for (const int child : nodes.children[i]) {
            file.element("nodes", child, "node");
            if (nodes.parent[size_t(child)] >= 0) throw Error(fmt::format("damaged: node {} has two parents", child));
            nodes.parent[size_t(child)] = int(i);
        }
    }
    std::vector<int> open;
    for (size_t i = 0; i < count; ++i)
        if (nodes.parent[i] < 0) open.push_back(int(i));
    size_t reached = 0;
    for (; !open.empty(); ++reached) {
        const size_t node = size_t(open.back());
        open.pop_back();
        nodes.world_from_node[node] = parent_from_node(file.element("nodes", int(node), "node"));
        if (const int parent = nodes.parent[node]; parent >= 0)
            nodes.world_from_node[node] = nodes.world_from_node[size_t(parent)] * nodes.world_from_node[node];
        open.insert(open.end(), nodes.children[node].begin(), nodes.children[node].end());
    }
    if (reached < count) throw Error("damaged: a node is its own ancestor");
    return nodes;
}

std::vector<glm::dmat4> world_from_bound(GltfDocument& file, const Nodes& nodes, int skin_index) {
    const GltfObject skin = file.element("skins", skin_index, "skin");
    const std::vector<int> joints = skin.indices("joints");
    if (joints.empty()) throw Error(fmt::format("damaged: {} has no joints", skin.name()));
    std::optional<GltfElements> inverse_bind;
    if (const int accessor = skin.index("inverseBindMatrices"); accessor >= 0) {
        inverse_bind.emplace(file, accessor, "MAT4", skin.name() + ", inverse bind matrices");
        if (inverse_bind->count() < joints.size())
            throw Error(fmt::format("damaged: {} has {} joints, but {} inverse bind matrices", skin.name(),
                                    joints.size(), inverse_bind->count()));
    }
    std::vector<glm::dmat4> matrices;
    for (size_t i = 0; i < joints.size(); ++i) {
        file.element("nodes", joints[i], "node");
        const glm::dmat4& joint = nodes.world_from_node[size_t(joints[i])];
        matrices.push_back(inverse_bind ? joint * inverse_bind->mat4(i) : joint);
    }
    return matrices;
}

}  // namespace

std::vector<GltfPlacedMesh> placed_meshes(GltfDocument& file) {
    const Nodes nodes = nodes_of(file);
    std::vector<int> roots;
    const size_t scenes = file.count("scenes");
    if (scenes > 0) {
        const int scene = std::max(0, file.root().index("scene"));
        roots = file.element("scenes", scene, "scene").indices("nodes");
        if (scenes > 1) file.notes.add("", fmt::format("of {} scenes, number {} is read", scenes, scene));
    } else {
        for (size_t i = 0; i < nodes.parent.size(); ++i)
            if (nodes.parent[i] < 0) roots.push_back(int(i));
    }
    if (file.count("animations") > 0)
        file.notes.add("", "its animations are not read: the model has the pose of its nodes");
    std::vector<GltfPlacedMesh> placed;
    std::vector<int> open(roots.rbegin(), roots.rend());
    std::vector<bool> is_seen(nodes.parent.size());
    while (!open.empty()) {
        const int index = open.back();
        open.pop_back();
        const GltfObject node = file.element("nodes", index, "node");
        if (is_seen[size_t(index)]) throw Error(fmt::format("damaged: {} is twice in its scene", node.name()));
        is_seen[size_t(index)] = true;
        if (const int mesh = node.index("mesh"); mesh >= 0) {
            GltfPlacedMesh one{mesh, index, nodes.world_from_node[size_t(index)]};
            if (const int skin = node.index("skin"); skin >= 0)
                one.world_from_bound = world_from_bound(file, nodes, skin);
            placed.push_back(std::move(one));
        }
        const std::vector<int>& children = nodes.children[size_t(index)];
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return placed;
}

}  // namespace relief
