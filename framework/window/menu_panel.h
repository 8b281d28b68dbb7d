// The panel beside the picture in the menu window. In the window module only.
#pragma once

#include <string>

#include "framework/lab/registry.h"

namespace relief {

class Stage;

/// The user's requests in the panel.
struct PanelWish {
    const LabEntry* lab = nullptr;
    int step = 0;  ///< 1: the next lab, -1: the one before
    bool restart = false, save = false;
    bool handout = false, error_map = false;  ///< show it, or hide it if it is shown
};

/// Draws labs, knobs, probes, counters and keys; `width` in pixels. Knobs and probe change the stage at once.
PanelWish draw_panel(Stage& stage, int width, bool error_map, const std::string& message);

/// Draws the stage's error, if any, over the upper part of the picture.
void draw_error(const Stage& stage, int panel_width);

}  // namespace relief
