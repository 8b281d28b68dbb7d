// Copies pictures into the window, and says why a picture is not there yet. In the window module only.
#pragma once

#include "framework/course/window/menu_layout.h"

namespace relief::window {

class Stage;
class Wipe;

/// Draws a note in the lower left corner of the picture: why there is no picture, or why it takes long.
void draw_opening(const Box& picture, const Stage& stage);

/// Copies the stage's picture, or its backdrop, into the window's framebuffer, and the picture of the wipe left of its
/// border. `picture` is the place of the picture alone.
void present(glm::ivec2 window, const Box& picture, const Stage& stage, const Wipe& wipe);

}  // namespace relief::window
