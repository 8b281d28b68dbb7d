// A cut through the whorls: the fine and the coarse model, the cage, and the rays of a column of texels.
#pragma once

#include "baker.h"

namespace relief::baking {

/// A line of the drawing, in metres: across from the model's axis, and up along it.
struct CutLine {
    glm::vec2 from, to;
    glm::vec3 color;
    float width;  ///< in line widths
};

/// `share` of a turn is where the cut is. `hits` is the second texture of a bake of this recipe.
std::vector<CutLine> cut_lines(const Recipe& recipe, const Mesh& high, const Image& hits, float share);

constexpr glm::vec3 hit_color{0.36f, 0.78f, 0.42f}, miss_color{0.93f, 0.28f, 0.20f}, wrong_color{0.68f, 0.36f, 0.95f},
    unwritten_color{0.85f, 0.0f, 0.85f};

}  // namespace relief::baking
