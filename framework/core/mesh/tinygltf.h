// The function of the module that holds TinyGLTF. framework/core/mesh/gltf.cpp opens it at first use.
#pragma once

#include "framework/core/mesh/gltf.h"

namespace relief {

/// Parses a .gltf or a .glb. Files that it names are in `folder`. Throws Error without a place, which the caller adds.
using ParseGltf = GltfModel(const std::string& bytes, const std::filesystem::path& folder, const ObjLimits& limits);

}  // namespace relief

extern "C" {
relief::ParseGltf relief_parse_gltf;
}
