// The panel's list of tasks and checks. In the window module only.
#pragma once

#include <imgui.h>

#include <optional>
#include <string>

#include "framework/course/check/verdict.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {

class Checks;

/// The sign of an outcome; of nothing: not checked yet.
struct Sign {
    const char* sign;
    ImVec4 color;
};
Sign sign_of(const std::optional<check::Outcome>& outcome);

/// `chosen` is the name of the check shown in place of the picture, or empty.
void draw_check_list(const Checks& checks, const std::string& chosen, MenuWish& wish);

}  // namespace relief::window
