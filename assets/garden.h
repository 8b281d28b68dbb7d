// Lab 08's models: a garden, plates on a ground, and a file whose material has another name.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace relief {

/// Names of files, and their texts: Wavefront OBJ and MTL.
std::vector<std::pair<std::string, std::string>> make_garden();

}  // namespace relief
