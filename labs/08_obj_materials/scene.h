// The scene of lab 08: surfaces of an OBJ file, each with the features that its program is compiled for.
#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/gl/gpu_mesh.h"
#include "obj_textures.h"

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

struct Piece : ObjSurface {
    unsigned features = 0;
    int program = 0;  ///< counts sets of features, in the order of their first piece

    bool has(Feature feature) const { return features & feature; }
    bool is_glass() const { return features & glass; }
};

/// Returns a set of features in the words of an MTL file, such as "Kd Ks norm".
std::string words(unsigned features);

struct Scene {
    Mesh mesh;                  ///< with tangents along growing u
    std::vector<Piece> pieces;  ///< in the order of the file, without invisible ones (opacity 0)
    int programs = 0;
    std::vector<std::string> notes;  ///< see ObjScene
};

/// Returns the scene of a model: see make_obj_scene().
Scene make_scene(ObjModel model, const MapSwitches& maps, const std::function<MapKind(const Image&)>& kind_of);

/// Returns a model of a thousand tiles. Each has a material of its own; there are four sets of features.
ObjModel thousand_tiles();

/// A scene as it is drawn.
struct DrawnScene {
    explicit DrawnScene(Scene made) : scene(std::move(made)) {}
    DrawnScene(const DrawnScene&) = delete;  // its mesh refers to this object

    const Scene scene;
    const GpuMesh mesh = upload([this] { return scene.mesh; });
    ObjTextures textures;
};

}  // namespace relief::materials
