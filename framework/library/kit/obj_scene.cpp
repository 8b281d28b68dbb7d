#include "framework/library/kit/obj_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/asset.h"
#include "framework/core/image/color_profile.h"
#include "framework/core/image/file.h"
#include "framework/library/kit/own_mesh.h"
#include "framework/library/mesh/uv_tangents.h"

namespace relief {
namespace {

namespace fs = std::filesystem;

/// Finds the maps of materials and their kinds. Each picture is examined once.
class MapFinder {
public:
    MapFinder(const MapSwitches& switches, const std::function<MapKind(const Image&)>& kind_of,
              std::vector<std::string>& notes)
        : switches_(switches), kind_of_(kind_of), notes_(notes) {}

    /// Sets the maps of a surface by its material.
    void find(ObjSurface& surface) {
        const Material& material = surface.material;
        if (switches_.colors) surface.colors = asset(material, "map_Kd", material.diffuse_map);
        if (switches_.highlights) surface.highlights = asset(material, "map_Ks", material.specular_map);
        if (switches_.masks) surface.mask = asset(material, "map_d", material.opacity_map);
        if (switches_.masks && surface.mask.empty() && has_alpha(surface.colors))
            surface.mask = surface.colors, surface.mask_is_alpha = true;
        if (switches_.normals) find_bumps(surface);
    }

    /// Adds a note that names the words of a material's file that have no effect on the picture.
    void note_unused_words(const Material& material) {
        constexpr std::array<std::string_view, 14> used = {"Kd",   "Ks",   "Ke",       "Ns",      "d",
                                                           "Tr",   "norm", "map_Kd",   "map_Ks",  "map_d",
                                                           "bump", "-bm",  "map_bump", "map_Bump"};
        std::vector<std::string> unused;
        for (const std::string& word : material.words)
            if (std::find(used.begin(), used.end(), word) == used.end()) unused.push_back(word);
        if (unused.empty()) return;
        const std::string last = unused.back();
        unused.pop_back();
        note(material, unused.empty() ? fmt::format("{} of '{}' has no effect here", last, material.name)
                                      : fmt::format("{} and {} of '{}' have no effect here", fmt::join(unused, ", "),
                                                    last, material.name));
    }

private:
    /// Returns the path of a map in the folder of assets. If the file is missing, adds a note and returns nothing.
    std::string asset(const Material& material, const char* keyword, const fs::path& file) {
        if (file.empty()) return {};
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored)) return file.lexically_proximate(course_root() / "assets").string();
        note(material, fmt::format("{} of '{}' is left out: {}", keyword, material.name, missing_file(file)));
        return {};
    }

    /// Finds the normals or heights of a surface.
    void find_bumps(ObjSurface& surface) {
        const Material& material = surface.material;
        surface.bumps = asset(material, "norm", material.normal_map);
        if (surface.bumps.empty()) {
            surface.bumps = asset(material, "map_bump", material.bump_map);
            if (!surface.bumps.empty()) surface.bump_kind = kind_of_bumps(material, surface.bumps);
            return;
        }
        surface.bump_kind = MapKind::normals;
        if (!material.bump_map.empty())
            note(material, fmt::format("map_bump of '{}' is left out: norm is there", material.name));
    }

    /// Returns the kind of a bump map. Adds a note if it does not hold heights.
    MapKind kind_of_bumps(const Material& material, const std::string& name) {
        const auto [kind, is_new] = kinds_.try_emplace(name);
        if (is_new) kind->second = kind_of_(read_asset(name));
        if (kind->second != MapKind::heights)
            note(material,
                 fmt::format("map_bump of '{}' {}", material.name,
                             kind->second == MapKind::normals ? "holds normals, not heights: read as norm"
                                                              : "holds neither heights nor normals: left out"));
        return kind->second;
    }

    /// Returns whether a picture, or none, has a fourth channel.
    bool has_alpha(const std::string& name) {
        if (name.empty()) return false;
        const auto [has, is_new] = has_alpha_.try_emplace(name);
        // A picture of the course is stored with its mip chain; a user's file would get one first.
        if (is_new)
            has->second = name.starts_with("..") ? read_image(course_root() / "assets" / name).channels == 4
                                                 : read_asset_chain(name, ColorSpace::srgb).channels == 4;
        return has->second;
    }

    void note(const Material& material, const std::string& message) {
        if (notes_.size() < 20) notes_.push_back(note_about({material.file, material.line}, message));
    }

    const MapSwitches& switches_;
    const std::function<MapKind(const Image&)>& kind_of_;
    std::vector<std::string>& notes_;
    std::map<std::string, MapKind> kinds_;
    std::map<std::string, bool> has_alpha_;
};

/// Returns the material of a subset: grey and not black if there is none, so that it is visible.
Material material_of(const ObjModel& model, const Subset& subset) {
    if (subset.material >= 0) return model.materials[size_t(subset.material)];
    Material missing;
    missing.name = "(missing)", missing.diffuse = glm::vec3(0.6f);
    return missing;
}

glm::dvec3 middle_of(const Mesh& mesh, const Subset& subset) {
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (uint32_t i = 0; i < subset.index_count; ++i) {
        const glm::dvec3 place = mesh.vertices[mesh.indices[subset.first_index + i]].position;
        low = glm::min(low, place), high = glm::max(high, place);
    }
    return (low + high) / 2.0;
}

}  // namespace

ObjScene make_obj_scene(ObjModel model, const MapSwitches& maps, const std::function<MapKind(const Image&)>& kind_of) {
    ObjScene scene{std::move(model.mesh), {}, std::move(model.notes)};
    set_uv_tangents(scene.mesh);
    MapFinder finder(maps, kind_of, scene.notes);
    for (const Subset& subset : model.subsets) {
        ObjSurface surface{.material = material_of(model, subset),
                           .first_index = subset.first_index,
                           .index_count = subset.index_count,
                           .centre = middle_of(scene.mesh, subset)};
        finder.note_unused_words(surface.material);
        if (surface.material.opacity == 0) continue;
        finder.find(surface);
        scene.surfaces.push_back(std::move(surface));
    }
    return scene;
}

std::vector<std::string> OwnObj::load(const fs::path& file) {
    ObjModel model = read_obj(file);
    for (Material& material : model.materials)
        for (fs::path* const map : {&material.diffuse_map, &material.specular_map, &material.opacity_map,
                                    &material.normal_map, &material.bump_map}) {
            std::error_code ignored;
            if (!fs::is_regular_file(*map, ignored)) continue;
            const bool is_colors = map == &material.diffuse_map || map == &material.specular_map;
            const std::string about_profile = profile_note(read_image(*map), !is_colors);
            const std::string line = note_about({*map}, about_profile);
            if (!about_profile.empty() && std::find(model.notes.begin(), model.notes.end(), line) == model.notes.end())
                model.notes.push_back(line);
            *map = fs::absolute(*map);
        }
    try {
        model.mesh = prepared_model(std::move(model.mesh), model.has_uvs, radius_);
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
    for (Vertex& vertex : model.mesh.vertices) vertex.position += glm::vec3(centre_);
    // All maps, so that each missing one has a note. Only the lab tells heights from normals.
    std::vector<std::string> notes = make_obj_scene(model, {}, [](const Image&) { return MapKind::heights; }).notes;
    model_ = std::move(model);
    return notes;
}

}  // namespace relief
