// glTF 2.0 models, .gltf and .glb, read into a mesh, with the normal map of their material.
//
// - All triangles of the default scene become one mesh, each with the matrix of its node. A file without scenes gives
//   its roots. Points and lines are ignored. Strips, fans, sparse accessors and compressed meshes are refused.
// - v grows upwards here, and downwards in glTF: v becomes 1 - v. Tangents and their handedness stay as they are,
//   because glTF's bitangent points up in the picture, too.
// - A mirroring node reverses the winding of its triangles and the handedness of its tangents.
// - A primitive without normals gets those of its triangles, and its tangents are ignored, as glTF demands. A normal of
//   zero length becomes that of a triangle at the vertex.
// - Only positions, normals, tangents, uv and the normal map are read: neither skins, nor animations, nor colours.
#pragma once

#include <filesystem>
#include <string>

#include "framework/core/mesh/mesh.h"
#include "framework/core/mesh/obj.h"

namespace relief {

struct GltfModel {
    Mesh mesh;
    bool has_uvs = false;  ///< every primitive has them: those of the normal map, or else the first
    /// Every primitive has tangents. Otherwise all of them are any_perpendicular() of the normal, with w = 1.
    bool has_tangents = false;
    std::string normal_map = {};  ///< the picture's file: that of the first material that has one; or empty
    double normal_scale = 1;      ///< factor on the map's x and y
};

/// Reads a model, and the files that it names, from its folder. Throws Error that names the file when it, or a file
/// that it needs, is missing, damaged or beyond `limits`, or has no triangles.
GltfModel read_gltf(const std::filesystem::path& file, const ObjLimits& limits = {});

/// Returns whether this program reads glTF: one for Windows or for a browser does not.
bool reads_gltf();

/// Returns whether a file's name ends in .gltf or .glb, in any case.
bool is_named_as_gltf(const std::filesystem::path& file);

}  // namespace relief
