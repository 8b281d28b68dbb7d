// The words of a lab's picture, in the window's fonts. In the window module only.
#pragma once

#include <vector>

#include "framework/core/lab/words.h"
#include "framework/course/window/menu_layout.h"

namespace relief::window {

/// Draws words over their picture, below all panels: those whose middle is in the columns from `begin` to `end`, in
/// pixels from the picture's left side. So a wipe shows each word whole, or not at all. Returns the places of their
/// grounds in the window.
std::vector<Box> draw_words(std::vector<PictureWord> words, const Box& picture, int begin, int end);

}  // namespace relief::window
