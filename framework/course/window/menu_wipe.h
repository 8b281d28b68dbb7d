// Two settings of a lab in one picture: A, the held setting, left of a border, and B, the current one, right of it. In
// the window module only.
#pragma once

#include <optional>

#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_stage.h"

namespace relief::window {

class Wipe {
public:
    bool on() const { return held_.has_value(); }
    /// Holds the knobs of the stage as A, in a lab of its own.
    void hold(const Stage& stage);
    void let_go() { held_.reset(); }
    /// Returns whether A has no picture yet: draw() compiles a part of it.
    bool is_opening() const { return held_ && held_->is_opening(); }
    /// Swaps A and the current setting.
    void swap(Stage& stage);

    /// Call it when the stage's shader files have changed: A uses the same files and must be redrawn as well.
    void changed() {
        if (held_) held_->changed();
    }
    /// Draws A at the size of the stage, with its camera, its probe and its time. Redraws only if one of them changed,
    /// or if `drawn` says that the stage was redrawn. A probe has the same colours in both.
    void draw(Stage& stage, glm::ivec2 size, double time, bool drawn);
    /// Draws the border and labels both settings by the knobs in which they differ.
    void draw_border(const Box& picture, float scale, const Stage& stage);

    GLuint framebuffer() const { return held_ ? held_->framebuffer() : 0; }
    /// The words of A's picture. Precondition: on().
    const std::vector<PictureWord>& words() const { return held_->words(); }
    /// Returns how many columns of the picture show A.
    int columns(int width) const { return int(border_ * float(width) + 0.5f); }
    /// The same, and 0 while A has no picture.
    int shown_columns(int width) const { return framebuffer() ? columns(width) : 0; }

private:
    std::optional<Stage> held_;
    float border_ = 0.5f;
};

}  // namespace relief::window
