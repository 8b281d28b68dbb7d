// Copies pictures into the window, and says why a picture is not there yet. In the window module only.
#pragma once

#include <string>

#include "framework/course/window/menu_layout.h"

namespace relief::window {

class Stage;
class Wipe;

/// Draws a note over the picture: in its lower left corner, or in its middle if it `is_alone` there.
void draw_note(const Box& picture, const std::string& note, bool is_alone);

/// Draws a note about the step of a picture that is missing or takes long.
void draw_opening(const Box& picture, const Stage& stage);

/// Copies the stage's picture, or its backdrop, into the window's framebuffer, and the picture of the wipe left of its
/// border. `picture` is the place of the picture alone.
void present(glm::ivec2 window, const Box& picture, const Stage& stage, const Wipe& wipe);

}  // namespace relief::window
