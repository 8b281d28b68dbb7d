// The cube and its map as files that another engine reads.
#pragma once

#include <filesystem>
#include <string>

#include "framework/core/base/mesh.h"

namespace relief::synctest {

/// Returns a Wavefront OBJ with normals and uv, triangle by triangle; its material is in `material_file`.
std::string synctest_obj(const Mesh& mesh, const std::string& material_file);

/// Writes the cube, the map, the expected picture, and a README.md that explains how to take the picture. Throws Error.
void write_synctest(const std::filesystem::path& folder);

}  // namespace relief::synctest
