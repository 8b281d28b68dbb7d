// A section through the whorls: the fine and the coarse model, the cage, and the rays of a column of texels.
#pragma once

#include <vector>

#include "baker.h"
#include "line_drawing.h"

namespace relief::baking {

/// Returns the lines of the section at `share` of a turn, in [0, 1], in metres: x is the distance from the model's
/// axis, y the height along it. `hits` is the second texture of a bake of this recipe. A cube and a file have no lines.
std::vector<DrawnLine> cut_lines(const Recipe& recipe, const Mesh& high, const Image& hits, float share);

}  // namespace relief::baking
