// The surfaces of an OBJ model, each with its material and the maps that were found for it; also of a user's own file.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "framework/core/base/own_file.h"
#include "framework/core/image/image.h"
#include "framework/library/mesh/obj.h"

namespace relief {

/// The content of a picture that an MTL file names as map_bump.
enum class MapKind { heights, normals, neither };

/// Which maps of the materials are read. Heights count as normals.
struct MapSwitches {
    bool colors = true, normals = true, highlights = true, masks = true;
    bool operator==(const MapSwitches&) const = default;
};
constexpr MapSwitches no_maps{.colors = false, .normals = false, .highlights = false, .masks = false};

/// The triangles of a material, as a range of ObjScene::mesh.
struct ObjSurface {
    Material material;
    uint32_t first_index = 0, index_count = 0;
    glm::dvec3 centre;  ///< of the bounding box
    // Names of assets, or empty. A picture elsewhere has a name that climbs out of the folder of assets.
    std::string colors{}, highlights{}, bumps{}, mask{};
    MapKind bump_kind = MapKind::neither;  ///< of `bumps`
    bool mask_is_alpha = false;            ///< `mask` is the fourth channel of a picture, else the first
};

struct ObjScene {
    Mesh mesh;                         ///< with tangents along growing u
    std::vector<ObjSurface> surfaces;  ///< in the order of the file, without invisible ones (opacity 0)
    /// About omitted and substituted parts, and words of the files that have no effect, "file:line: message".
    std::vector<std::string> notes;
};

/// Returns the surfaces of a model, with the maps that are switched on. `kind_of` decides how map_bump is read; `norm`
/// holds normals. Without map_d the fourth channel of map_Kd is the mask, if there is one. A map that is missing is
/// left out, with a note. A surface without a material is grey. Throws as read_image() does for map_bump and,
/// without map_d, for map_Kd, and as `kind_of` does.
ObjScene make_obj_scene(ObjModel model, const MapSwitches& maps, const std::function<MapKind(const Image&)>& kind_of);

/// An OBJ file of the user with its materials, for a knob with Knobs::choice_or_file().
class OwnObj final : public OwnFile {
public:
    /// Moves each model so that the middle of its bounding box is `centre`, and scales the box's half diagonal to
    /// `radius`: see prepared_model().
    OwnObj(const glm::dvec3& centre, double radius) : centre_(centre), radius_(radius) {}

    const char* kind() const override { return "an OBJ file"; }
    bool accepts(const std::filesystem::path& file) const override { return lower_ending(file) == ".obj"; }
    const ObjModel& model() const { return model_; }

private:
    /// Also throws when a map of a material is there and is no picture. The notes are those of make_obj_scene().
    std::vector<std::string> load(const std::filesystem::path& file) override;

    const glm::dvec3 centre_;
    const double radius_;
    ObjModel model_;
};

}  // namespace relief
