// The triangles of one primitive of a glTF file, in the space of its mesh.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/library/mesh/gltf_document.h"

namespace relief {

/// Up to four joints that move a vertex, of one pair of attributes JOINTS_n and WEIGHTS_n.
struct GltfInfluence {
    std::array<uint32_t, 4> joint;
    glm::dvec4 weight;
};

struct GltfPrimitive {
    Mesh mesh;  ///< morphed, with all normals and tangents; v grows upwards
    bool has_uvs = false;
    bool has_tangents = false;  ///< every tangent is the file's
    /// For each vertex, one from each pair of JOINTS_n and WEIGHTS_n.
    std::vector<std::vector<GltfInfluence>> influences = {};
};

/// Returns the triangles of a primitive: none for points and lines, with a note. `weights` are those of its morph
/// targets; missing ones are 0. Throws Error for damage, and for more than `most_corners`.
GltfPrimitive read_primitive(GltfDocument& file, const GltfObject& primitive, const std::string& name,
                             const std::vector<double>& weights, size_t most_corners);

/// Returns the object of the texture whose uv a primitive has: its normal map's, or else that of another texture of its
/// material. Empty for a primitive without textures.
GltfObject texture_of_uv(const GltfDocument& file, const GltfObject& primitive);

}  // namespace relief
