// Writes a mesh with tangents and a normal map as glTF 2.0.
#pragma once

#include <string>

#include "framework/core/mesh/mesh.h"

namespace relief {

/// glTF 2.0: the text of NAME.gltf, and the content of NAME.bin with positions, normals, tangents, uv and indices.
struct GltfFiles {
    std::string json, buffer;
};
/// Returns the files of a mesh of at most 65,536 vertices, with a normal map.
GltfFiles gltf_files(const Mesh& mesh, const std::string& name, const std::string& map_file);

}  // namespace relief
