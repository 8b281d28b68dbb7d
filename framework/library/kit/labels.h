// Text in a picture: names, numbers and scales.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/lab/lab.h"
#include "framework/core/lab/words.h"
#include "framework/library/kit/tiles.h"
#include "framework/library/kit/word_layout.h"

namespace relief {

enum class Align { left, centre, right };

/// Collects text and shapes, lays them out by lay_out(), and draws them over the picture in one draw call. Positions
/// and sizes are in pixels of the frame, from its upper left corner. Colours are in stored sRGB. Draws nothing on a
/// probe. Drops the labels of a draw that threw. Where a frame takes its words, it gives them to it, and draws none.
class Labels {
public:
    /// Returns the height of a line of text for a frame of this size: legible, and the same share of any larger
    /// picture.
    static float line_height(glm::ivec2 size) { return letters(size).usual; }
    /// Returns the letters of labels.png for a frame of this size.
    static Letters letters(glm::ivec2 size);

    /// Adds text, with a degree sign for `~`, on a dark plate that keeps it legible. `place` is the upper end of
    /// the text at its left, its middle or its right.
    void text(const std::string& text, glm::vec2 place, float height, Align align = Align::left,
              glm::vec3 color = {0.93f, 0.92f, 0.89f});
    /// Returns the tiles with their lower ends cut off: a strip for so many captions below the picture of each tile, at
    /// most half of it. Tiles that are too narrow for a caption of `longest` letters have two lines for each. For small
    /// tiles, whose pictures captions would hide.
    static std::vector<Tile> with_feet(glm::ivec2 size, std::vector<Tile> tiles, int captions, int longest);

    /// Adds text in the middle of a tile: line 0 is its title, -1 the last line. The captions of a tile with a foot are
    /// in the foot.
    void caption(glm::ivec2 size, const Tile& tile, int line, const std::string& text,
                 glm::vec3 color = {0.93f, 0.92f, 0.89f});
    /// Adds a colour and its name to the strip at the lower end of a tile. Another `row` begins a row of the strip.
    void legend(glm::ivec2 size, const Tile& tile, const std::string& text, glm::vec3 color, int row = 0);
    /// Adds notes about files along the lower edge. If they do not fit into half of the picture, the last line counts
    /// the others.
    void notes(const std::vector<std::string>& notes);
    void rectangle(glm::vec2 place, glm::vec2 size, glm::vec4 color);
    /// Marks a pixel: a bright cross on a dark one, with a gap in the middle.
    void cross(glm::vec2 middle, float reach);

    /// Adds the scale of heat() in the lowest scale_height() pixels of a frame, from `low` to `high`. Ticks divide a
    /// logarithmic scale into `parts` of one ratio. A linear scale has one part.
    static int scale_height(glm::ivec2 size) { return int(std::ceil(0.9f * scale_line(size))); }
    void scale(glm::ivec2 size, const std::string& low, const std::string& high, int parts = 1);

    /// Draws into the whole of frame.target, and clears the collection.
    void draw(const Frame& frame);

private:
    static float scale_line(glm::ivec2 size) { return std::max(11.0f, 0.042f * float(std::min(size.x, size.y))); }
    struct Corner {
        glm::vec2 place, uv;
        glm::vec4 color;
    };
    struct Uploaded {
        VertexArrayName layout;
        BufferName corners;
    };
    /// Adds a word of this draw, and forgets those of a draw that threw.
    void add(PictureWord word);
    /// Adds a word whose place and size are those of a tile.
    void add_in_tile(glm::ivec2 size, const Tile& tile, PictureWord word);
    static std::vector<Corner> corners_of(const WordLayout& layout);

    std::vector<PictureWord> words_;  ///< places and sizes in pixels
    int64_t draw_ = 0;                ///< draws_begun() of the draw to which words_ belong
    std::optional<Uploaded> uploaded_;
    Programs program_{"common/label.vert", "common/label.frag"};
    Texture letters_ = load_texture("labels.png", {.wrap = Wrap::clamp});
};

}  // namespace relief
