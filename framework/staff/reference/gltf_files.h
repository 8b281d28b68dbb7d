// Writes a mesh with tangents and a normal map as glTF 2.0.
#pragma once

#include <string>

#include "framework/core/base/mesh.h"

namespace relief {

/// glTF 2.0: the text of NAME.gltf, and the content of NAME.bin with positions, normals, tangents, uv and indices.
struct GltfFiles {
    std::string json, buffer;
};
/// Returns the files of a mesh with a normal map. Throws Error unless it has 1 to 65,535 vertices, since an index has
/// 16 bits, and glTF reserves 65,535.
GltfFiles gltf_files(const Mesh& mesh, const std::string& name, const std::string& map_file);

}  // namespace relief
