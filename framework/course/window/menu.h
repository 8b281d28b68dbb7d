// The menu window: labs, knobs, probes and counters around the picture. Part of the window module.
#pragma once

#include <optional>
#include <string>

#include "framework/core/lab/shot.h"

namespace relief::window {

/// The window's initial state.
struct MenuStart {
    std::string lab_folder;         ///< folder name of the lab; the first lab if there is no such folder
    std::optional<Shot> shot = {};  ///< knobs, camera and probe; the lab's defaults if missing
    bool error_map = false;
    std::string check = {};  ///< name of a check to show in place of the picture; empty for none
};

/// Opens the window. Returns the exit code after it is closed.
int open_menu(const MenuStart& start);

}  // namespace relief::window

/// Entry point of the window module for the application.
extern "C" int relief_run_menu(const relief::window::MenuStart& start);
