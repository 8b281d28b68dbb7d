// glTF 2.0 models, .gltf and .glb, read into a mesh, with the normal maps of their materials.
//
// - All triangles of the default scene become one mesh, each with the matrix of its node: lists, strips and fans. A
//   file without scenes gives its roots.
// - Morph targets have the weights of the node, or else of the mesh. Skins have the pose of their joints.
// - v grows upwards here, and downwards in glTF: v becomes 1 - v. Tangents and their handedness stay as they are,
//   because glTF's bitangent points up in the picture, too. KHR_texture_transform is applied to the uv.
// - A mirroring node reverses the winding of its triangles and the handedness of its tangents.
// - A primitive without normals gets those of its triangles, and its tangents are ignored, as glTF demands. A normal of
//   zero length becomes that of a triangle at the vertex. Missing and unusable tangents are MikkTSpace's.
// - Whatever else changes positions, normals, tangents or uv is refused, or named by a note. The table in
//   labs/staff/README.md lists the features.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/library/mesh/obj.h"

namespace relief {

/// How a texture goes on beyond its border.
enum class GltfWrap { repeat, clamp, mirror };

struct GltfNormalMap {
    std::string picture;  ///< the bytes of its file
    double scale = 1;     ///< factor on the map's x and y
    GltfWrap wrap_u = GltfWrap::repeat, wrap_v = wrap_u;
};

/// A range of Mesh::indices with one material.
struct GltfPart {
    uint32_t first_index = 0, index_count = 0;
    int normal_map = -1;  ///< index into GltfModel::normal_maps; -1: smooth
};

struct GltfModel {
    Mesh mesh;
    bool has_uvs = false;       ///< some primitive has uv: those of its normal map, or of another texture, or the first
    bool has_tangents = false;  ///< every tangent is the file's; false for a model without uv
    /// The file's positions are those of the mesh plus `centre`. Zero unless the model is far from the origin, where
    /// floats are coarse.
    glm::dvec3 centre{0};
    std::vector<GltfNormalMap> normal_maps = {};
    std::vector<GltfPart> parts = {};     ///< in order; together all of mesh.indices. Empty: one part without a map
    std::vector<std::string> notes = {};  ///< what was not read or was replaced, one line each; at most 20
};

/// Reads a model, and the files that it names, from its folder. The notes name the file. Throws Error that names the
/// file when it, or a file that it needs, is missing, damaged or beyond `limits`, or has no triangles.
GltfModel read_gltf(const std::filesystem::path& file, const ObjLimits& limits = {});

/// Parses the bytes of a .gltf or a .glb. Files that it names are in `folder`. Throws Error without a place.
GltfModel parse_gltf(const std::string& bytes, const std::filesystem::path& folder, const ObjLimits& limits = {});

/// Returns whether a file's name ends in .gltf or .glb, in any case.
bool is_named_as_gltf(const std::filesystem::path& file);

}  // namespace relief
