// The nodes of a glTF file: where its meshes are, and its skins.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/library/mesh/gltf_document.h"

namespace relief {

/// A mesh of a node in the default scene. Throws Error for a skin without joints, and for damage.
struct GltfPlacedMesh {
    int mesh = -1;
    int node = -1;
    glm::dmat4 world_from_mesh{1};
    /// For each joint of the node's skin, the joint's world transform times its inverse bind matrix. They replace
    /// world_from_mesh. Empty without a skin.
    std::vector<glm::dmat4> world_from_bound = {};
};

/// Returns the meshes of the default scene's nodes, in order. A file without scenes gives its roots. Adds a note about
/// other scenes and about animations. Throws Error for damage.
std::vector<GltfPlacedMesh> placed_meshes(GltfDocument& file);

}  // namespace relief
