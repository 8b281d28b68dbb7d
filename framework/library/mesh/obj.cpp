#include "framework/library/mesh/obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>

#include "framework/core/base/file.h"
#include "framework/library/mesh/frame.h"
#include "framework/library/mesh/obj_parts.h"
#include "framework/library/mesh/polygon.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
constexpr size_t most_bytes_of_materials = size_t{16} << 20, most_libraries = 64;

struct CornerHash {
    size_t operator()(const obj::Corner& corner) const {
        return obj::mix(obj::mix(uint64_t(uint32_t(corner.position)) << 32 | uint32_t(corner.uv)) ^
                        uint32_t(corner.normal));
    }
};

Vertex vertex_at(const obj::Faces& faces, const obj::Corner& corner) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(faces.normals[size_t(corner.normal)]));
    return {.position = faces.positions[size_t(corner.position)],
            .normal = normal,
            .tangent = glm::dvec4(any_perpendicular(normal), 1),
            .uv = corner.uv < 0 ? glm::vec2(0) : faces.uvs[size_t(corner.uv)]};
}

/// Returns for each material name of the faces its index in `materials`, or -1. The first of several equal names
/// counts.
std::vector<int> resolve(const std::vector<obj::Named>& names, const std::vector<Material>& materials,
                         const fs::path& file, obj::Notes& notes) {
    std::map<std::string_view, int> indices;
    for (size_t i = 0; i < materials.size(); ++i) indices.try_emplace(materials[i].name, int(i));
    std::vector<int> result;
    for (const auto& [name, line] : names) {
        const auto found = indices.find(name);
        result.push_back(found == indices.end() ? -1 : found->second);
        if (found == indices.end())
            notes.add({file, line}, fmt::format("no material file describes '{}'", obj::excerpt(name)));
    }
    return result;
}

/// Keeps one of several neighbouring corners at one position. Those have no angle, by which a triangulation tells the
/// inside. Leaves a polygon as it is if that would leave fewer than three corners.
void drop_repeated(std::vector<glm::dvec3>& polygon, std::vector<obj::Corner>& corners) {
    std::vector<size_t> kept;
    for (size_t i = 0; i < polygon.size(); ++i)
        if (polygon[i] != polygon[(i + polygon.size() - 1) % polygon.size()]) kept.push_back(i);
    if (kept.size() == polygon.size() || kept.size() < 3) return;
    for (size_t i = 0; i < kept.size(); ++i) polygon[i] = polygon[kept[i]], corners[i] = corners[kept[i]];
    polygon.resize(kept.size()), corners.resize(kept.size());
}

/// Adds a note for faces without uv if others have them, and for faces that are not drawn since their material's
/// opacity is 0.
void note_invisible_parts(ObjModel& model, const obj::Faces& faces, const std::vector<int>& material_of,
                          const fs::path& file, obj::Notes& notes) {
    const auto lacks_uv = [&](const obj::Face& face) {
        return std::any_of(&faces.corners[face.first], &faces.corners[face.first] + face.count,
                           [](const obj::Corner& corner) { return corner.uv < 0; });
    };
    size_t without_uv = 0;
    std::set<int> invisible;
    for (const obj::Face& face : faces.faces) {
        if (lacks_uv(face) && without_uv++ == 0) model.line_without_uv = face.line;
        const int material = face.material < 0 ? -1 : material_of[size_t(face.material)];
        if (material >= 0 && model.materials[size_t(material)].opacity == 0) invisible.insert(material);
    }
    if (model.has_uvs && without_uv > 0)
        notes.add({file, model.line_without_uv},
                  without_uv == 1 ? "this face has corners without uv (vt): they get 0, 0; the other faces keep theirs"
                                  : fmt::format("{} faces, of which this is the first, have corners without uv (vt): "
                                                "they get 0, 0; the others keep theirs",
                                                without_uv));
    for (const int i : invisible) {
        const Material& material = model.materials[size_t(i)];
        const bool has_d = std::find(material.words.begin(), material.words.end(), "d") != material.words.end();
        notes.add({material.file, material.line},
                  has_d ? fmt::format("'{}' has opacity 0 (d 0): its faces are not drawn", material.name)
                        : fmt::format("'{}' has opacity 0 (Tr 1): its faces are not drawn. Tr is transparency; "
                                      "a program that means opacity writes d",
                                      material.name));
    }
}

void add_triangles(ObjModel& model, const obj::Faces& faces, const std::vector<int>& material_of) {
    std::unordered_map<obj::Corner, uint32_t, CornerHash> vertex_of;
    std::vector<std::vector<uint32_t>> indices;  // of each subset
    std::map<int, size_t> subset_of;             // by material
    std::vector<glm::dvec3> polygon;
    std::vector<obj::Corner> corners;
    std::vector<uint32_t> triangles;
    for (const obj::Face& face : faces.faces) {
        const int material = face.material < 0 ? -1 : material_of[size_t(face.material)];
        const auto [subset, is_new] = subset_of.try_emplace(material, indices.size());
        if (is_new) {
            indices.emplace_back();
            model.subsets.push_back({.material = material});
        }
        polygon.clear(), corners.clear(), triangles.clear();
        for (uint32_t i = 0; i < face.count; ++i) {
            const obj::Corner& corner = faces.corners[face.first + i];
            polygon.push_back(faces.positions[size_t(corner.position)]), corners.push_back(corner);
        }
        drop_repeated(polygon, corners);
        triangulate(polygon, triangles);
        for (const uint32_t i : triangles) {
            const auto [vertex, is_first] = vertex_of.try_emplace(corners[i], uint32_t(model.mesh.vertices.size()));
            if (is_first) model.mesh.vertices.push_back(vertex_at(faces, corners[i]));
            indices[subset->second].push_back(vertex->second);
        }
    }
    for (size_t i = 0; i < indices.size(); ++i) {
        std::vector<uint32_t>& all = model.mesh.indices;
        model.subsets[i].first_index = uint32_t(all.size());
        model.subsets[i].index_count = uint32_t(indices[i].size());
        all.insert(all.end(), indices[i].begin(), indices[i].end());
        indices[i] = {};
    }
}

/// `materials_of` returns the materials of the libraries that the faces name.
template <class Materials>
ObjModel read_model(std::string_view text, const fs::path& file, const ObjLimits& limits, Materials materials_of) {
    const size_t most_bytes = std::min(limits.bytes, size_t{1} << 31);  // so that an int can count everything in it
    if (text.size() > most_bytes)
        throw Error({file}, fmt::format("{} bytes, the limit is {}", text.size(), most_bytes));
    obj::Notes notes;
    obj::Faces faces = obj::read_faces(text, file, limits, notes);
    ObjModel model;
    model.materials = materials_of(faces.libraries, notes);
    model.has_normals =
        std::all_of(faces.corners.begin(), faces.corners.end(), [](const obj::Corner& c) { return c.normal >= 0; });
    model.origin = faces.origin;
    model.has_uvs =
        std::any_of(faces.corners.begin(), faces.corners.end(), [](const obj::Corner& c) { return c.uv >= 0; });
    if (!model.has_normals) obj::add_missing_normals(faces);
    const std::vector<int> material_of = resolve(faces.materials, model.materials, file, notes);
    note_invisible_parts(model, faces, material_of, file, notes);
    add_triangles(model, faces, material_of);
    model.notes = notes.lines();
    return model;
}

/// Returns the files that a `mtllib` names: several separated by blanks, or one with blanks in its name.
std::vector<fs::path> library_files(const std::string& names, const fs::path& folder) {
    std::error_code ignored;
    if (const fs::path file = obj::path_in(folder, names); fs::exists(file, ignored)) return {file};
    std::vector<fs::path> files;
    std::string_view rest = names;
    for (std::string_view name = obj::take_name(rest); !name.empty(); name = obj::take_name(rest))
        files.push_back(obj::path_in(folder, std::string(name)));
    return files;
}

}  // namespace

ObjModel read_obj(const fs::path& file, const ObjLimits& limits) {
    const fs::path folder = file.parent_path();
    const auto materials_of = [&](const std::vector<obj::Named>& libraries, obj::Notes& notes) {
        std::vector<Material> materials;
        std::set<fs::path> seen;
        for (const auto& [names, line] : libraries)
            for (const fs::path& library : library_files(names, folder)) {
                if (seen.size() == most_libraries || !seen.insert(library).second) continue;
                try {
                    const std::string text = read_file(library, most_bytes_of_materials);
                    std::vector<Material> more = obj::read_materials(text, library, folder, notes);
                    std::move(more.begin(), more.end(), std::back_inserter(materials));
                } catch (const Error& error) {
                    std::error_code ignored;
                    notes.add({file, line},
                              fmt::format("no materials: {}",
                                          fs::exists(library, ignored) ? error.what() : missing_file(library)));
                }
            }
        return materials;
    };
    return read_model(read_file(file, limits.bytes), file, limits, materials_of);
}

ObjModel parse_obj(std::string_view text, std::string_view mtl_text, const fs::path& name, const ObjLimits& limits) {
    return read_model(text, name, limits, [&](const std::vector<obj::Named>&, obj::Notes& notes) {
        return obj::read_materials(mtl_text, fs::path(name).replace_extension(".mtl"), name.parent_path(), notes);
    });
}

}  // namespace relief
