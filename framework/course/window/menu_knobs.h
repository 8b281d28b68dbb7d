// A lab's knobs as sliders, lists and boxes. In the window module only.
#pragma once

#include <string>

namespace relief::window {

class Motion;
class Stage;

/// Draws the knobs in their groups and applies changes; the stage then redraws. A right click on a slider lets it run.
/// `seek` is the name of a knob to scroll to and mark. It is cleared afterwards.
void draw_knobs(Stage& stage, Motion& motion, std::string& seek);

}  // namespace relief::window
