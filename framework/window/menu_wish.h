// What the user asks for in one frame, in whichever part of the window. In the window module only.
#pragma once

#include <optional>
#include <string>

#include "framework/base/error.h"
#include "framework/lab/registry.h"

namespace relief {

struct MenuWish {
    const LabEntry* lab = nullptr;
    int step = 0;                             ///< 1: the next lab, -1: the one before
    bool handout = false, error_map = false;  ///< show it, or hide it if it is shown
    bool help = false, search = false;        ///< the same
    bool tasks = false;                       ///< open the panel's checks
    std::optional<std::string> check = {};    ///< show this check; "": the picture again
    std::string knob = {}, probe = {};        ///< show the slider of this knob; look at this probe
    std::string value = {};                   ///< set that knob to it
    Place edit = {};                          ///< open it in the editor
};

}  // namespace relief
