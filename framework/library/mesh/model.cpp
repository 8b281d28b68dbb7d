#include "framework/library/mesh/model.h"

#include <utility>

namespace relief {

Model read_model(const std::filesystem::path& file) {
    Model model;
    if (is_named_as_gltf(file)) {
        static_cast<GltfModel&>(model) = read_gltf(file);
        model.tangents_follow_uv = model.has_uvs;
        return model;
    }
    ObjModel obj = read_obj(file);
    model.mesh = std::move(obj.mesh), model.notes = std::move(obj.notes);
    model.has_uvs = obj.has_uvs, model.line_without_uv = obj.line_without_uv, model.centre = obj.origin;
    return model;
}

}  // namespace relief
