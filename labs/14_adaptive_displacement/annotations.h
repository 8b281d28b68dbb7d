// The marks over the pictures of lab 14: holes, the eye's field of view, and legends.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/core/kit/labels.h"

namespace relief::adaptive {

/// Returns the pixels that are holes, counted from the lower left corner. `sums` has the probe `winding`. On a closed
/// surface a hole has a sum that is not 0. On an open one it has the sum 0, and another one close by on all four sides.
std::vector<glm::ivec2> holes_in(const Image& sums, bool is_closed);

/// Marks pixels of a tile by squares. `size` is that of the frame.
void mark(Labels& labels, glm::ivec2 size, const Tile& tile, const std::vector<glm::ivec2>& pixels);

struct LegendEntry {
    std::string text;
    glm::vec3 color;
};
/// Adds a legend in the lower left corner of a tile, the first row below the second.
void add_legend(Labels& labels, glm::ivec2 size, const Tile& tile, const std::vector<std::vector<LegendEntry>>& rows);

/// The eye and its field of view, as eight lines.
class SightLines {
public:
    /// Draws the field of view of `eye`, as `seen_by` sees it, up to `reach` metres from the eye.
    void draw(const Camera& seen_by, const Camera& eye, double reach);

private:
    Programs program_{"14_adaptive_displacement/sight.vert", "14_adaptive_displacement/sight.frag"};
    std::optional<VertexArrayName> no_corners_;
};

}  // namespace relief::adaptive
