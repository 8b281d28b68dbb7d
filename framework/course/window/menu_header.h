// The line at the top of the window: the lab, its tasks, and the buttons of the overlays. In the window module only.
#pragma once

#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {

class Checks;
class Stage;

void draw_header(const Box& box, float scale, const Stage& stage, const Checks& checks, MenuWish& wish);

/// Returns a title such as "10  Parallax offset". Titles do not change while the window is open.
const std::string& title_of(const LabEntry& lab);

}  // namespace relief::window
