// The menu window: labs, knobs, probes and counters around the picture. It lives in the window module.
#pragma once

#include <string>

namespace relief {

/// Opens the window at a lab (its folder's name) and returns the exit code when it is closed.
int open_menu(const std::string& lab_folder);

}  // namespace relief

/// What the window module offers to the application.
extern "C" int relief_run_menu(const char* lab_folder);
