// Lab 08's models: a garden, plates on a ground, fences, and a file with broken references.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace relief {

/// Returns names of files and their texts: Wavefront OBJ and MTL.
std::vector<std::pair<std::string, std::string>> make_garden();

}  // namespace relief
