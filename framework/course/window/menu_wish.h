// The user's requests in one frame, from any part of the window. In the window module only.
#pragma once

#include <optional>
#include <string>

#include "framework/core/base/error.h"
#include "framework/core/lab/registry.h"

namespace relief::window {

struct MenuWish {
    const LabEntry* lab = nullptr;
    int step = 0;                             ///< 1: the next lab, -1: the previous one
    bool handout = false, error_map = false;  ///< toggle
    bool help = false, search = false;        ///< toggle
    bool labs = false;                        ///< open the start page
    bool save_map = false;                    ///< save the map that the lab makes
    bool save_heights = false;                ///< save the heights that the lab shows
    std::string message = {};                 ///< show this in the status line
    bool tasks = false;                       ///< open the panel's checks
    std::optional<std::string> check = {};    ///< show this check; "": the picture again
    std::string knob = {}, probe = {};        ///< show the slider of this knob; show this probe
    std::string value = {};                   ///< set `knob` to this value
    Place edit = {};                          ///< open this place in the editor
};

}  // namespace relief::window
