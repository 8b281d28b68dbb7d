// Wavefront OBJ models and their MTL materials, read into a mesh.
//
// Reads v, vt, vn, f, s, usemtl and mtllib; ignores groups, lines, points and curves.
// - Corners with the same indices of position, uv and normal share a vertex.
// - Polygons are triangulated and keep their winding; see polygon.h. Of neighbouring corners at one position, one
// stays.
// - A corner without a normal, or with one of zero length, gets the mean of the faces at its position, weighted by
//   their angles there (Thürmer and Wüthrich 1998). The mean is over its smoothing group, or over all faces before the
//   first `s`. After `s off`, and where the mean is zero (a two-sided sheet), it gets its face's normal. If the face
//   has no area, it gets +z.
// - A corner without uv gets (0, 0). The others keep theirs.
// - Positions are read in double precision. A model far from the origin is moved there before they are rounded to
// float:
//   see ObjModel::origin.
// - Tangents do *not* follow the uv: vertex.tangent is any_perpendicular() of the normal, with w = 1, until the caller
//   computes better ones.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "framework/core/base/mesh.h"

namespace relief {

/// A material of an MTL file. Defaults apply to values that the file does not give. Colours are stored as written.
struct Material {
    std::string name;
    glm::vec3 diffuse = {1, 1, 1};   ///< Kd
    glm::vec3 specular = {0, 0, 0};  ///< Ks
    glm::vec3 emission = {0, 0, 0};  ///< Ke
    float shininess = 1;             ///< Ns
    float opacity = 1;               ///< d, or else 1 - Tr; clamped to [0, 1]
    float bump_scale = 1;            ///< -bm of the bump map
    // Paths that can be opened (relative ones begin with the model's folder), or empty.
    std::filesystem::path diffuse_map = {};   ///< map_Kd
    std::filesystem::path specular_map = {};  ///< map_Ks
    std::filesystem::path opacity_map = {};   ///< map_d
    std::filesystem::path bump_map = {};      ///< map_Bump, map_bump or bump: heights, and in some files normals
    std::filesystem::path normal_map = {};    ///< norm
    /// Keywords of its statements and options of its maps, each once, in the order of the file, at most 32. They tell a
    /// renderer which of them it does not use, also of those that have no member here (Ka, map_Ke, -clamp).
    std::vector<std::string> words = {};
    std::filesystem::path file = {};  ///< the MTL file; `line` is the line of its newmtl
    int line = 0;
};

/// The triangles of one material, as a range of Mesh::indices.
struct Subset {
    uint32_t first_index = 0, index_count = 0;
    int material = -1;  ///< an index into ObjModel::materials; -1: no material, or one that no file describes
};

struct ObjModel {
    Mesh mesh;
    std::vector<Subset> subsets;  ///< one per material, in the order of their first face; together all of mesh.indices
    std::vector<Material> materials;
    bool has_normals = false;  ///< every corner has a normal of non-zero length in the file
    bool has_uvs = false;      ///< a corner has uv in the file
    int line_without_uv = 0;   ///< of the first face with a corner without uv; 0: every corner has uv
    /// The file's positions are those of the mesh plus this. It is the middle of the bounding box if that is farther
    /// from 0 than the box's diagonal, and else 0.
    glm::dvec3 origin{0};
    /// Parts of the files that were ignored or replaced, one line each, "name:line: message" (see note_about()); at
    /// most 20.
    std::vector<std::string> notes;
};

/// Limits of a model. Labs and `relief map` have the same ones: a lab can show what `map bake` bakes.
struct ObjLimits {
    size_t bytes = size_t{128} << 20;  ///< of the OBJ file; clamped to 2 GiB
    size_t corners = 3'000'000;        ///< of all faces together; each takes up to 150 bytes
};

/// Reads a model, and the material files that it names, from its folder. A fault in a material file gives a note.
/// Throws Error with file and line for:
/// - a number that is unreadable or not finite, or an index out of range;
/// - a face of fewer than 3 or more than 1024 corners;
/// - a file without faces, or beyond `limits`.
ObjModel read_obj(const std::filesystem::path& file, const ObjLimits& limits = {});

/// Parses texts in memory likewise, and opens no files. `name` replaces the file's name in messages, and its folder is
/// put in front of relative maps. `mtl_text` replaces all material files that the model names.
ObjModel parse_obj(std::string_view text, std::string_view mtl_text = {},
                   const std::filesystem::path& name = "model.obj", const ObjLimits& limits = {});

}  // namespace relief
