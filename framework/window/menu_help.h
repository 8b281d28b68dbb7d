// All keys, over the picture. In the window module only.
#pragma once

#include "framework/window/menu_layout.h"

namespace relief {

/// Draws the list; `open` becomes false when a click goes elsewhere.
void draw_help(const Box& picture, float scale, bool& open);

}  // namespace relief
