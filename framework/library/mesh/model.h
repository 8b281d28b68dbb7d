// A model of any format that the course reads, OBJ or glTF, in one form.
#pragma once

#include "framework/library/mesh/gltf.h"

namespace relief {

struct Model : GltfModel {
    /// The tangents follow the uv: they are the file's, or MikkTSpace's. False for OBJ, and for a model without uv.
    bool tangents_follow_uv = false;
    int line_without_uv = 0;  ///< see ObjModel::line_without_uv
};

/// Reads an OBJ or glTF file, by the ending of its name. Throws as read_obj() and read_gltf() do.
Model read_model(const std::filesystem::path& file);

}  // namespace relief
