// A section through the whorls: the fine and the coarse model, the cage, and the rays of a column of texels.
#pragma once

#include <optional>
#include <vector>

#include "baker.h"
#include "framework/core/gl/vertex_stream.h"
#include "framework/core/kit/tiles.h"

namespace relief::baking {

/// A line of the drawing, in metres: x is the distance from the model's axis, y the height along it.
struct CutLine {
    glm::vec2 from, to;
    glm::vec3 color;
    float width;  ///< factor on the drawing's line width
};

/// Returns the lines of the section at `share` of a turn, in [0, 1]. `hits` is the second texture of a bake of this
/// recipe. A cube and a file have no lines.
std::vector<CutLine> cut_lines(const Recipe& recipe, const Mesh& high, const Image& hits, float share);

class CutDrawing {
public:
    /// Draws the whole section in the middle of a tile. Sets the viewport.
    void draw(const Tile& tile, const std::vector<CutLine>& lines);

private:
    Programs program_{"07_baking/lines.vert", "07_baking/lines.frag"};
    std::optional<VertexArrayName> layout_;
    struct Corner {
        glm::vec2 place;  ///< in clip coordinates
        glm::vec4 color;
    };
    VertexStream corners_{{{0, 2, GL_FLOAT, offsetof(Corner, place)}, {1, 4, GL_FLOAT, offsetof(Corner, color)}}};
};

}  // namespace relief::baking
