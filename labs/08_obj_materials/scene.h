// What an OBJ file and its materials become: surfaces, each with the features that its program is compiled for.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "framework/mesh/obj.h"
#include "task.h"

namespace relief::materials {

/// What a material names, as the shaders have it.
enum Feature : unsigned {
    color_map = 1,
    highlight_map = 2,
    normal_map = 4,
    height_map = 8,
    mask_map = 16,
    glass = 32,  ///< its opacity is below 1
};
constexpr unsigned all_features = 63;

/// The triangles of a material, as a range of Scene::mesh.
struct Piece {
    Material material;
    unsigned features = 0;
    int program = 0;  ///< counts sets of features, in the order of their first piece
    uint32_t first_index = 0, index_count = 0;
    glm::dvec3 centre;  ///< of the box around it
    // Names of assets, or empty.
    std::string colors, highlights, bumps, mask;

    bool has(Feature feature) const { return features & feature; }
    bool is_glass() const { return features & glass; }
};

/// A set of features as an MTL file would name them: "Kd Ks norm".
std::string words(unsigned features);

struct Scene {
    Mesh mesh;                  ///< with tangents along growing u
    std::vector<Piece> pieces;  ///< in the order of the file; none with opacity 0
    int programs = 0;
    std::vector<std::string> notes;  ///< what was left out or made up, "file:line: message"
};

/// Without maps nothing but numbers counts. `kind_of` decides about map_bump. Throws what read_obj throws: then there
/// is no scene at all.
Scene make_scene(ObjModel model, bool with_maps, const std::function<MapKind(const Image&)>& kind_of);

/// A thousand tiles, each of a material of its own, with four sets of features.
ObjModel thousand_tiles();

/// By level of a mask: what its alpha is multiplied by, so that as many places are above 1/2 as on level 0 (Castano
/// 2010). Places lie between texels, too.
std::vector<float> kept_scales(const std::vector<Image>& levels);

/// Share of the places of a level that are above the threshold.
double share_above(const Image& level, double threshold);

}  // namespace relief::materials
