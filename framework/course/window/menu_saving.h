// Saves what the window shows. In the window module only.
#pragma once

#include <string>

#include "framework/course/window/menu_stage.h"

namespace relief::window {

/// Each of these writes a PNG file in the working directory under the next free name, prints the name on standard
/// output, and returns a message for the status line. An error is such a message, too, and goes to standard error.
std::string save_picture(const Stage& stage);
/// Saves the map that the lab makes, with 16 bits.
std::string save_map(const Stage& stage);
/// Saves the heights that the lab shows, painted or not, with 16 bits.
std::string save_heights(const Stage& stage);

}  // namespace relief::window
