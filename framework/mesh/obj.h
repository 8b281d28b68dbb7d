// Wavefront OBJ models and their MTL materials, read into a mesh.
//
// Read are v, vt, vn, f, s, usemtl and mtllib; groups, lines, points and curves are not needed here.
// - Corners with the same indices of position, uv and normal share a vertex.
// - Polygons are cut into triangles and keep their winding; see polygon.h.
// - A corner without a normal, or with one of length zero, gets the mean of the faces at its position, weighted by
//   their angles there (Thürmer and Wüthrich 1998): of those in its smoothing group, or of all while no `s` has come.
//   After `s off`, and where the mean is zero (a sheet with two sides), it gets its face's own; without area, +z.
// - A corner without uv gets (0, 0).
// - Tangents are *not* those of the uv: vertex.tangent is any_perpendicular() of the normal, with w = 1, until someone
//   makes better ones.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "framework/mesh/mesh.h"

namespace relief {

/// What a material of an MTL file says; the defaults are what holds where it says nothing. Colours are as written.
struct Material {
    std::string name;
    glm::vec3 diffuse = {1, 1, 1};   ///< Kd
    glm::vec3 specular = {0, 0, 0};  ///< Ks
    glm::vec3 ambient = {0, 0, 0};   ///< Ka
    glm::vec3 emission = {0, 0, 0};  ///< Ke
    int illumination = 0;            ///< illum, a number of MTL's list of lighting models
    float shininess = 1;             ///< Ns
    float opacity = 1;               ///< d or, where there is none, 1 - Tr; in [0, 1]
    float bump_scale = 1;            ///< -bm of the bump map
    // Ready to open (a relative one has the model's folder in front), or empty.
    std::filesystem::path diffuse_map;       ///< map_Kd
    std::filesystem::path specular_map;      ///< map_Ks
    std::filesystem::path shininess_map;     ///< map_Ns
    std::filesystem::path opacity_map;       ///< map_d
    std::filesystem::path ambient_map;       ///< map_Ka
    std::filesystem::path emission_map;      ///< map_Ke
    std::filesystem::path bump_map;          ///< map_Bump, map_bump or bump: heights, and in some files normals
    std::filesystem::path normal_map;        ///< norm
    std::filesystem::path displacement_map;  ///< disp or map_disp
    std::filesystem::path file = {};         ///< that describes it, and the line of its newmtl
    int line = 0;
};

/// The triangles of one material, as a range of Mesh::indices.
struct Subset {
    uint32_t first_index = 0, index_count = 0;
    int material = -1;  ///< an index into ObjModel::materials; -1: none, or one that no file describes
};

struct ObjModel {
    Mesh mesh;
    std::vector<Subset> subsets;  ///< one a material, in the order of their first face; together all of mesh.indices
    std::vector<Material> materials;
    bool has_normals = false;  ///< every corner had a usable one in the file
    bool has_uvs = false;      ///< every corner had one in the file
    /// What was left out or made up, a line each, "file:line: message"; no more than 20.
    std::vector<std::string> notes;
};

struct ObjLimits {
    size_t bytes = size_t{128} << 20;  ///< of the OBJ file; more than 2 GiB are not taken
    size_t corners = 6'000'000;        ///< of all faces together; they take up to 150 bytes each
};

struct ObjOptions {
    /// All normals are made from the faces, as where the file has none.
    bool recompute_normals = false;
    /// The file was made for left-handed axes, as Direct3D's are: z is negated, faces are wound the other way round,
    /// and v comes from the top.
    bool left_handed = false;
};

/// Reads a model and the material files that it names, which lie in its folder. Throws Error with file and line for
/// what is wrong: a number that is unreadable or not finite, an index out of range, a face of fewer than 3 corners or
/// more than 1024, no faces at all, or more than `limits`. What is wrong with a material file is a note.
ObjModel read_obj(const std::filesystem::path& file, const ObjLimits& limits = {}, const ObjOptions& options = {});

/// The same of texts in memory: `name` stands for the file in messages and in the maps' folder, `mtl_text` for whatever
/// files the model names. Opens no files.
ObjModel parse_obj(std::string_view text, std::string_view mtl_text = {},
                   const std::filesystem::path& name = "model.obj", const ObjLimits& limits = {},
                   const ObjOptions& options = {});

}  // namespace relief
