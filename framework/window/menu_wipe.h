// Two settings of a lab in one picture: A, which is held, left of a border, and the present one, B, right of it. In the
// window module only.
#pragma once

#include <optional>

#include "framework/window/menu_layout.h"
#include "framework/window/menu_stage.h"

namespace relief {

class Wipe {
public:
    bool on() const { return held_.has_value(); }
    /// Holds the knobs of the stage as A, in a lab of their own.
    void hold(const Stage& stage);
    void let_go() { held_.reset(); }
    /// A becomes the present setting, and what was present is held.
    void swap(Stage& stage);

    /// A's saved shaders and edits of what both share are its own affair: call it when the stage has to be drawn anew.
    void changed() {
        if (held_) held_->changed();
    }
    /// Draws A as large as the stage, by its camera, its probe and its time, when one of them changed or the stage was
    /// `drawn`. A probe has the same colours in both.
    void draw(Stage& stage, glm::ivec2 size, double time, bool drawn);
    /// The border, and the names of both settings: the knobs in which they differ.
    void draw_border(const Box& picture, float scale, const Stage& stage);

    GLuint framebuffer() const { return held_ ? held_->framebuffer() : 0; }
    /// How many columns of the picture are A's.
    int columns(int width) const { return int(border_ * float(width) + 0.5f); }

private:
    std::optional<Stage> held_;
    float border_ = 0.5f;
};

}  // namespace relief
