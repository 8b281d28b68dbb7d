// The list of all keys, over the picture. In the window module only.
#pragma once

#include "framework/course/window/menu_layout.h"

namespace relief::window {

/// Draws the list. Sets `open` to false after a click outside it.
void draw_help(const Box& picture, float scale, bool& open);

}  // namespace relief::window
