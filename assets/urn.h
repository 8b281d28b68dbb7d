// The urn: a model in a file, turned on a lathe.
#pragma once

#include <string>

namespace relief {

/// A Wavefront OBJ text: quads around the y axis with u around (from +z towards +x) and v up, and their normals.
std::string make_urn();

}  // namespace relief
