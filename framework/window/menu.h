// The menu window: labs, knobs, probes and counters around the picture. Part of the window module.
#pragma once

#include <string>

namespace relief {

/// Opens the window at a lab (its folder's name) and returns the exit code when it is closed.
int open_menu(const std::string& lab_folder);

}  // namespace relief

/// The functions that the application calls in the window module.
extern "C" int relief_run_menu(const char* lab_folder);
