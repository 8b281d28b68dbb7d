// One pixel, through the functions of the lab's shader task files, over the picture. In the window module only.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framework/window/menu_layout.h"

namespace relief {

class Stage;

class PixelExplanation {
public:
    /// Of this pixel from now on: column and row from the picture's upper left corner.
    void ask(glm::ivec2 pixel) { pixel_ = pixel, lines_.clear(), told_ = false; }
    void close() { pixel_.reset(), lines_.clear(); }
    bool is_open() const { return pixel_.has_value(); }

    /// Whether it is still to be computed, and whoever waits has been told so.
    bool wanted() const { return told_ && lines_.empty(); }
    /// As `relief explain` does, in the current context: it may take seconds.
    void compute(const Stage& stage);
    void draw(const Box& picture, float scale);

private:
    std::optional<glm::ivec2> pixel_;
    std::vector<std::string> lines_;
    std::string conclusion_;
    bool told_ = false;
};

}  // namespace relief
