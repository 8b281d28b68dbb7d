// The keys of the window. In the window module only.
#pragma once

#include "framework/core/context/glfw_window.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {

/// The parts of the window that change the meaning of a key.
struct OpenParts {
    bool typing = false;  ///< in a text field
    bool search = false, list = false, help = false, labs = false;
    bool part = false;    ///< a part of the window has the keys: arrows, space and the like move through it
    bool active = false;  ///< a slider or a field is being changed
    bool explanation = false, check = false, brush = false, wipe = false, motion = false, handout = false;
    bool presents = false;  ///< the picture alone
};

/// Adds the action of a pressed or repeated key to the wish; nothing for a key without an action.
void add_key(const Key& key, const OpenParts& open, MenuWish& wish);
/// Adds the action of a typed character: "?" and "/", whose keys depend on the keyboard's layout.
void add_character(unsigned character, const OpenParts& open, MenuWish& wish);

}  // namespace relief::window
