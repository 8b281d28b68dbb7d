// A section through the whorls: the fine and the coarse model, the cage, and the rays of a column of texels.
#pragma once

#include "baker.h"

namespace relief::baking {

/// A line of the drawing, in metres: x is the distance from the model's axis, y the height along it.
struct CutLine {
    glm::vec2 from, to;
    glm::vec3 color;
    float width;  ///< factor on the drawing's line width
};

/// Returns the lines of the section at `share` of a turn, in [0, 1]. `hits` is the second texture of a bake of this
/// recipe. A cube has no lines.
std::vector<CutLine> cut_lines(const Recipe& recipe, const Mesh& high, const Image& hits, float share);

constexpr glm::vec3 hit_color{0.36f, 0.78f, 0.42f}, miss_color{0.93f, 0.28f, 0.20f}, wrong_color{0.68f, 0.36f, 0.95f},
    unwritten_color{0.85f, 0.0f, 0.85f};

}  // namespace relief::baking
