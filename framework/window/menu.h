// The menu window: labs, knobs, probes and counters around the picture. Part of the window module.
#pragma once

#include <optional>
#include <string>

#include "framework/lab/shot.h"

namespace relief {

/// What the window opens with.
struct MenuStart {
    std::string lab_folder;         ///< its name; the first lab where there is none of that name
    std::optional<Shot> shot = {};  ///< knobs, camera and probe; else the lab's own
    bool error_map = false;
    std::string check = {};  ///< show this check in place of the picture
};

/// Opens the window and returns the exit code when it is closed.
int open_menu(const MenuStart& start);

}  // namespace relief

/// The functions that the application calls in the window module.
extern "C" int relief_run_menu(const relief::MenuStart& start);
