// A lab's knobs as sliders, lists and boxes. In the window module only.
#pragma once

#include <string>

namespace relief::window {

class Stage;

/// Draws the knobs in their groups and applies changes; the stage then redraws. `seek` is the name of a knob to scroll
/// to and mark. It is cleared afterwards.
void draw_knobs(Stage& stage, std::string& seek);

}  // namespace relief::window
