// The scene of an OBJ file: surfaces, each with its material and the features that its program is compiled for.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/mesh/obj.h"
#include "task.h"

namespace relief::materials {

#include "shaders/08_obj_materials/feature_bits.glsl"

/// The features that a material can name.
enum Feature : unsigned {
    color_map = COLOR_MAP,
    highlight_map = HIGHLIGHT_MAP,
    normal_map = NORMAL_MAP,
    height_map = HEIGHT_MAP,
    mask_map = MASK_MAP,
    glass = GLASS
};
/// Their words in an MTL file.
constexpr std::array<std::pair<Feature, const char*>, 6> feature_words = {{{color_map, "Kd"},
                                                                           {highlight_map, "Ks"},
                                                                           {normal_map, "norm"},
                                                                           {height_map, "bump"},
                                                                           {mask_map, "d"},
                                                                           {glass, "glass"}}};
constexpr unsigned all_features = 63;

/// Which maps of the materials are read. Heights count as normals.
struct MapSwitches {
    bool colors = true, normals = true, highlights = true, masks = true;
    bool operator==(const MapSwitches&) const = default;
};
constexpr MapSwitches no_maps{.colors = false, .normals = false, .highlights = false, .masks = false};

/// The triangles of a material, as a range of Scene::mesh.
struct Piece {
    Material material;
    unsigned features = 0;
    int program = 0;  ///< counts sets of features, in the order of their first piece
    uint32_t first_index = 0, index_count = 0;
    glm::dvec3 centre;  ///< of the bounding box
    // Names of assets, or empty.
    std::string colors, highlights, bumps, mask;
    bool mask_is_alpha = false;  ///< `mask` is the fourth channel of a picture, else the first

    bool has(Feature feature) const { return features & feature; }
    bool is_glass() const { return features & glass; }
};

/// Returns a set of features in the words of an MTL file, such as "Kd Ks norm".
std::string words(unsigned features);

struct Scene {
    Mesh mesh;                  ///< with tangents along growing u
    std::vector<Piece> pieces;  ///< in the order of the file, without invisible ones (opacity 0)
    int programs = 0;
    /// About omitted and substituted parts, and words of the files that have no effect, "file:line: message".
    std::vector<std::string> notes;
};

/// Returns the scene of a model, with the maps that are switched on. `kind_of` decides how map_bump is read. Without
/// map_d the fourth channel of map_Kd is the mask, if there is one. A map that is missing is left out, with a note.
/// Throws as read_image() does for a bump map, and as `kind_of` does.
Scene make_scene(ObjModel model, const MapSwitches& maps, const std::function<MapKind(const Image&)>& kind_of);

/// Returns a model of a thousand tiles. Each has a material of its own; there are four sets of features.
ObjModel thousand_tiles();

}  // namespace relief::materials
