// Text in a picture: names, numbers and scales.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/lab/lab.h"
#include "framework/core/lab/words.h"
#include "framework/library/kit/tiles.h"

namespace relief {

enum class Align { left, centre, right };

/// Collects text and shapes, then draws them over the picture in one draw call. Positions and sizes are in pixels of
/// the frame, from its upper left corner. Colours are in stored sRGB. Draws nothing on a probe. Drops the labels of a
/// draw that threw. While pictures have no words, it collects them for WithoutWords, and draws none.
class Labels {
public:
    /// Returns the height of a line of text for a frame of this size: legible, and the same share of any larger
    /// picture. Words that will be laid over the picture get more room, since their letters do not shrink with it.
    static float line_height(glm::ivec2 size) {
        return has_words() ? usual_line(size) : std::max(11.0f, 0.06f * float(std::min(size.x, size.y)));
    }
    static float width(const std::string& text, float height) { return float(text.size()) * height * letter_aspect; }

    /// Adds ASCII text, with a degree sign for `~`, on a dark plate that keeps it legible. `place` is the upper end of
    /// the text at its left, its middle or its right.
    void text(const std::string& text, glm::vec2 place, float height, Align align = Align::left,
              glm::vec3 color = {0.93f, 0.92f, 0.89f});
    /// Adds text in the middle of a tile: line 0 is the first, -1 the last. Its height is line_height() if the tile has
    /// enough room.
    void caption(glm::ivec2 size, const Tile& tile, int line, const std::string& text,
                 glm::vec3 color = {0.93f, 0.92f, 0.89f});
    /// Adds notes about files along the lower edge, wrapped, in letters that are legible. If they do not fit into half
    /// of the picture, the last line counts the others.
    void notes(glm::ivec2 size, const std::vector<std::string>& notes);
    void rectangle(glm::vec2 place, glm::vec2 size, glm::vec4 color);
    /// Marks a pixel: a bright cross on a dark one, with a gap in the middle.
    void cross(glm::vec2 middle, float reach);
    /// Adds the colours of heat(), from 0 on the left to 1 on the right.
    void heat_scale(glm::vec2 place, glm::vec2 size);

    /// Adds the scale of heat() in the lowest scale_height() pixels of a frame. Its left end is `low`; each tick is ten
    /// times the previous one. The scale keeps its height, so that tiles do not move when words are left out.
    static int scale_height(glm::ivec2 size) { return int(std::ceil(0.9f * usual_line(size))); }
    void log_scale(glm::ivec2 size, const std::string& low, const std::string& high, int ticks);

    /// Draws into the whole of frame.target, and clears the collection.
    void draw(const Frame& frame);

private:
    static float usual_line(glm::ivec2 size) { return std::max(11.0f, 0.042f * float(std::min(size.x, size.y))); }
    static constexpr float letter_aspect = 0.5f;
    struct Corner {
        glm::vec2 place, uv;
        glm::vec4 color;
    };
    struct Uploaded {
        VertexArrayName layout;
        BufferName corners;
    };
    void quad(glm::vec2 place, glm::vec2 size, glm::vec2 low, glm::vec2 high, glm::vec4 color);
    void forget_earlier_draws();
    std::vector<Corner>& corners_of_this_draw();
    /// Returns whether pictures have no words; then it keeps this one, with places and sizes in pixels.
    bool leaves_out(PictureWord word);

    std::vector<Corner> corners_;
    std::vector<PictureWord> words_;
    int64_t draw_ = 0;  ///< draws_begun() of the draw to which corners_ and words_ belong
    std::optional<Uploaded> uploaded_;
    Programs program_{"common/label.vert", "common/label.frag"};
    Texture letters_ = load_texture("labels.png", {.wrap = Wrap::clamp});
};

}  // namespace relief
