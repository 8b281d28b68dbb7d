// Explains one pixel by the values in the lab's shader task files, over the picture. In the window module only.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/window/menu_layout.h"

namespace relief::window {

class Stage;

class PixelExplanation {
public:
    /// Selects a pixel of the stage's picture after this many edits: column and row from its upper left corner.
    void ask(glm::ivec2 pixel, int64_t edits) { pixel_ = pixel, edits_ = edits, lines_.clear(), told_ = false; }
    /// Closes it after a later edit: it explains another picture.
    void close_after_edits(int64_t edits) {
        if (edits != edits_) close();
    }
    void close() { pixel_.reset(), lines_.clear(); }
    bool is_open() const { return pixel_.has_value(); }

    /// Returns whether it has yet to be computed and the user has been told to wait.
    bool wanted() const { return told_ && lines_.empty(); }
    /// Computes the same as `relief explain`, in the current context. May take seconds.
    void compute(const Stage& stage);
    void draw(const Box& picture, float scale);

private:
    std::optional<glm::ivec2> pixel_;
    int64_t edits_ = 0;
    std::vector<std::string> lines_;
    std::string conclusion_;
    bool told_ = false;
};

}  // namespace relief::window
