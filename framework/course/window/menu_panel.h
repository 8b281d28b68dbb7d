// The panel beside the picture: the knobs and probes, or the checks. In the window module only.
#pragma once

#include <string>

#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_wish.h"

namespace relief::window {

class Brush;
class Checks;
class Motion;
class Stage;

class Panel {
public:
    /// Draws the panel. Knobs and probe change the stage at once. `check` is the name of the check on screen, or empty.
    void draw(const Box& box, Stage& stage, Motion& motion, const Checks& checks, const std::string& check,
              bool error_map, Brush& brush, MenuWish& wish);

    void show_knobs() { wanted_ = "Knobs"; }
    void show_checks() { wanted_ = "Checks"; }
    /// Scrolls to a knob and marks it for a moment.
    void seek(const std::string& knob) { seek_ = knob, show_knobs(); }

private:
    bool begin_tab(const char* name);

    std::string wanted_, seek_;
};

}  // namespace relief::window
