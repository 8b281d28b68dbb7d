// A brush for the heights of a lab: raises, lowers and smooths them in the picture. In the window module only.
#pragma once

#include <optional>
#include <vector>

#include "framework/library/kit/made_map.h"

namespace relief::window {

class Stage;
struct MenuWish;

class Brush {
public:
    bool is_on() const { return is_on_; }
    /// Turns the brush on, if the lab has heights to paint, or off. Returns whether the lab has them.
    bool toggle(const Stage& stage);
    /// Call it when another lab is opened: drops the steps of undo.
    void forget();

    /// Draws the brush's settings in the panel, if the lab has heights to paint.
    void draw(Stage& stage, MenuWish& wish);
    /// Paints from the last place to a pixel of the picture while `is_down`. Throws the lab's exceptions.
    void move(Stage& stage, glm::dvec2 pixel, bool is_down);
    /// Draws a ring around the painted part. `at` is the upper left corner of the picture on the screen.
    void draw_ring(Stage& stage, glm::ivec2 at, glm::dvec2 pixel) const;

    /// Takes back a stroke, or makes it again. Returns whether there was one.
    bool undo(Stage& stage) { return go(stage, before_, after_); }
    bool redo(Stage& stage) { return go(stage, after_, before_); }

private:
    using Steps = std::vector<Image>;
    static bool go(Stage& stage, Steps& from, Steps& to);
    void begin_stroke(PaintLayer& layer);

    bool is_on_ = false, is_down_ = false;
    glm::dvec2 last_{};
    int kind_ = Dab::raise;
    float width_ = 40, strength_ = 0.3f;
    Steps before_, after_;  ///< values of the layer
};

}  // namespace relief::window
