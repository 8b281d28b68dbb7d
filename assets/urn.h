// The urn: a model file of a surface of revolution.
#pragma once

#include <string>

namespace relief {

/// Returns a Wavefront OBJ text: quads around the y axis with normals, u around (from +z towards +x) and v up.
std::string make_urn();

}  // namespace relief
