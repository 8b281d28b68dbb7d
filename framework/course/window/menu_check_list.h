// The panel's list of tasks and checks. In the window module only.
#pragma once

#include <string>

#include "framework/course/window/menu_wish.h"

namespace relief::window {

class Checks;

/// `chosen` is the name of the check shown in place of the picture, or empty.
void draw_check_list(const Checks& checks, const std::string& chosen, MenuWish& wish);

}  // namespace relief::window
