// A drawing of lines in a plane, such as a section, with its own scale.
#pragma once

#include <optional>
#include <vector>

#include "framework/core/gl/vertex_stream.h"
#include "framework/library/kit/tiles.h"

namespace relief {

struct DrawnLine {
    glm::vec2 from, to;  ///< in any unit of length; y points up
    glm::vec3 color;     ///< as sRGB stores it
    float width;         ///< factor on the line width, 0.003 of the tile's shorter side, at least a pixel
};

class LineDrawing {
public:
    /// Draws all lines in the middle of a tile, over its present content. They keep their proportions, and fill 84 % of
    /// the tile's width or height. Lines without length are left out. Sets the viewport. The depth test stays as it is.
    void draw(const Tile& tile, const std::vector<DrawnLine>& lines);

private:
    struct Corner {
        glm::vec2 place;  ///< in clip coordinates
        glm::vec4 color;
    };
    static std::vector<Corner> corners_of(glm::vec2 size, const std::vector<DrawnLine>& lines);

    Programs program_{"07_baking/lines.vert", "07_baking/lines.frag"};
    std::optional<VertexArrayName> layout_;
    VertexStream corners_{{{0, 2, GL_FLOAT, offsetof(Corner, place)}, {1, 4, GL_FLOAT, offsetof(Corner, color)}}};
};

}  // namespace relief
