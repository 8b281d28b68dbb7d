// A lab's knobs as sliders, lists and boxes. In the window module only.
#pragma once

#include <string>

namespace relief {

class Stage;

/// Draws them in their groups and turns them; the stage draws anew what was turned. `seek`: the name of a knob to show
/// and to mark, emptied when that is done.
void draw_knobs(Stage& stage, std::string& seek);

}  // namespace relief
