#include "scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/paths.h"
#include "framework/core/image/asset.h"
#include "framework/core/mesh/uv_tangents.h"

namespace relief::materials {
namespace {

namespace fs = std::filesystem;

/// Finds the maps of materials and their kinds. Each picture is examined once.
class Maps {
public:
    Maps(const std::function<MapKind(const Image&)>& kind_of, std::vector<std::string>& notes)
        : kind_of_(kind_of), notes_(notes) {}

    /// Returns the path of a map in the folder of assets. If the file is missing, adds a note and returns nothing.
    std::string asset(const Material& material, const char* keyword, const fs::path& file) {
        if (file.empty()) return {};
        std::error_code ignored;
        if (fs::is_regular_file(file, ignored)) return file.lexically_proximate(course_root() / "assets").string();
        note(material,
             fmt::format("{} of '{}' is left out: {} is not there", keyword, material.name, file.filename().string()));
        return {};
    }

    /// Finds the asset of a material's normals or heights. Returns its feature, or 0.
    unsigned find_bumps(const Material& material, std::string& bumps) {
        bumps = asset(material, "norm", material.normal_map);
        if (bumps.empty()) {
            bumps = asset(material, "map_bump", material.bump_map);
            return bumps.empty() ? 0 : bump(material, bumps);
        }
        if (!material.bump_map.empty())
            note(material, fmt::format("map_bump of '{}' is left out: norm is there", material.name));
        return normal_map;
    }

    /// Returns whether a picture, or none, has a fourth channel.
    static bool has_alpha(const std::string& name) {
        return !name.empty() && read_asset_chain(name, ColorSpace::srgb).channels == 4;
    }

    /// Adds a note that names the words of a material's file that have no effect on the picture.
    void unused_words(const Material& material) {
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
    /// Returns the feature of a bump map. Adds a note if it does not hold heights. Returns 0 if it holds no normals
    /// either.
    unsigned bump(const Material& material, const std::string& name) {
        const auto [kind, is_new] = kinds_.try_emplace(name);
        if (is_new) kind->second = kind_of_(read_asset(name));
        if (kind->second == MapKind::heights) return height_map;
        const bool normals = kind->second == MapKind::normals;
        note(material, fmt::format("map_bump of '{}' {}", material.name,
                                   normals ? "holds normals, not heights: read as norm"
                                           : "holds neither heights nor normals: left out"));
        return normals ? unsigned(normal_map) : 0;
    }

    void note(const Material& material, const std::string& message) {
        if (notes_.size() < 20) notes_.push_back(Error({material.file.filename(), material.line}, message).what());
    }

    const std::function<MapKind(const Image&)>& kind_of_;
    std::vector<std::string>& notes_;
    std::map<std::string, MapKind> kinds_;
};

}  // namespace

std::string words(unsigned features) {
    std::string text;
    for (const auto& [feature, word] : feature_words)
        if (features & feature) text.append(text.empty() ? "" : " ").append(word);
    return text;
}

Scene make_scene(ObjModel model, const MapSwitches& switches, const std::function<MapKind(const Image&)>& kind_of) {
    Scene scene{std::move(model.mesh), {}, 0, std::move(model.notes)};
    set_uv_tangents(scene.mesh);
    Maps maps(kind_of, scene.notes);
    std::map<unsigned, int> program_of;
    for (const Subset& subset : model.subsets) {
        Piece piece;
        if (subset.material >= 0) {
            piece.material = model.materials[size_t(subset.material)];
        } else {  // grey and not black, so that a missing material is visible
            piece.material.name = "(missing)";
            piece.material.diffuse = glm::vec3(0.6f);
        }
        const Material& material = piece.material;
        maps.unused_words(material);
        if (material.opacity == 0) continue;
        if (material.opacity < 1) piece.features |= glass;
        if (switches.colors) piece.colors = maps.asset(material, "map_Kd", material.diffuse_map);
        if (switches.highlights) piece.highlights = maps.asset(material, "map_Ks", material.specular_map);
        if (switches.masks) piece.mask = maps.asset(material, "map_d", material.opacity_map);
        if (switches.masks && piece.mask.empty() && maps.has_alpha(piece.colors))
            piece.mask = piece.colors, piece.mask_is_alpha = true;
        if (switches.normals) piece.features |= maps.find_bumps(material, piece.bumps);
        if (!piece.colors.empty()) piece.features |= color_map;
        if (!piece.highlights.empty()) piece.features |= highlight_map;
        if (!piece.mask.empty()) piece.features |= mask_map;
        piece.program = program_of.try_emplace(piece.features, int(program_of.size())).first->second;
        piece.first_index = subset.first_index, piece.index_count = subset.index_count;
        glm::dvec3 low(INFINITY), high(-INFINITY);
        for (uint32_t i = 0; i < subset.index_count; ++i) {
            const glm::dvec3 place = scene.mesh.vertices[scene.mesh.indices[subset.first_index + i]].position;
            low = glm::min(low, place), high = glm::max(high, place);
        }
        piece.centre = (low + high) / 2.0;
        scene.pieces.push_back(std::move(piece));
    }
    scene.programs = int(program_of.size());
    return scene;
}

ObjModel thousand_tiles() {
    constexpr int columns = 40, rows = 25;
    std::string obj = "s off\n", mtl;
    for (int i = 0; i < columns * rows; ++i) {
        const double x = 0.15 * (i % columns - columns / 2), z = 0.15 * (i / columns - rows / 2);
        for (const auto& [dx, dz] : {std::pair(0.0, 0.14), {0.14, 0.14}, {0.14, 0.0}, {0.0, 0.0}})
            obj += fmt::format("v {:.3f} 0 {:.3f}\nvt {:.3f} {:.3f}\n", x + dx, z + dz, 4 * dx, -4 * dz);
        obj += fmt::format("usemtl {0}\nf {1}/{1} {2}/{2} {3}/{3} {4}/{4}\n", i, 4 * i + 1, 4 * i + 2, 4 * i + 3,
                           4 * i + 4);
        const auto shade = [&](int prime) { return 0.25 + 0.6 * ((i * prime) % 101) / 100; };
        mtl +=
            fmt::format("newmtl {}\nKd {:.2f} {:.2f} {:.2f}\n{}", i, shade(37), shade(53), shade(71),
                        std::array{"", "map_Kd paving_albedo.png\n", "map_d wire_mask.png\n",
                                   "map_Kd bricks_albedo.png\nmap_bump bricks_normal.png\n"}[size_t(i * 7 % 11 % 4)]);
    }
    return parse_obj(obj, mtl, course_root() / "assets" / "thousand.obj");
}

}  // namespace relief::materials
