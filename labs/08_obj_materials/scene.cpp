#include "scene.h"

#include <fmt/format.h>

#include <map>

#include "framework/core/base/paths.h"

namespace relief::materials {
namespace {

unsigned features_of(const ObjSurface& surface) {
    unsigned features = 0;
    if (!surface.colors.empty()) features |= color_map;
    if (!surface.highlights.empty()) features |= highlight_map;
    if (surface.bump_kind == MapKind::normals) features |= normal_map;
    if (surface.bump_kind == MapKind::heights) features |= height_map;
    if (!surface.mask.empty()) features |= mask_map;
    if (surface.material.opacity < 1) features |= glass;
    return features;
}

}  // namespace

std::string words(unsigned features) {
    std::string text;
    for (const auto& [feature, word] : feature_words)
        if (features & feature) text.append(text.empty() ? "" : " ").append(word);
    return text;
}

Scene make_scene(ObjModel model, const MapSwitches& maps, const std::function<MapKind(const Image&)>& kind_of) {
    ObjScene from = make_obj_scene(std::move(model), maps, kind_of);
    Scene scene{std::move(from.mesh), {}, 0, std::move(from.notes)};
    std::map<unsigned, int> program_of;
    for (ObjSurface& surface : from.surfaces) {
        const unsigned features = features_of(surface);
        const int program = program_of.try_emplace(features, int(program_of.size())).first->second;
        scene.pieces.push_back({std::move(surface), features, program});
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
