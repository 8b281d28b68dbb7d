// The user's requests in one frame, from any part of the window. In the window module only.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "framework/core/base/error.h"
#include "framework/core/lab/registry.h"

namespace relief::window {

/// A request to the window without parameters, by a key or a button. `toggle` opens what is closed, and closes what is
/// open.
enum class WindowAction {
    toggle_help,
    open_search,
    close_search,
    take_found,  ///< goes to the result that is marked in the search
    close_list,
    open_labs,  ///< the start page
    close_labs,
    choose_lab,  ///< opens the lab that is marked on the start page
    next_lab,
    previous_lab,
    reset_lab,
    larger,
    smaller,
    usual_size,
    quit,
};

/// The same to the lab that is open.
enum class LabAction {
    next_part,  ///< gives the keys to the next part of the window
    leave_parts,
    reset_camera,
    turn_camera,  ///< or stop it
    stop_motion,
    pause,  ///< or go on
    undo,
    redo,
    explain_pixel,
    close_explanation,
    close_check,
    show_tasks,  ///< opens the panel's checks
    toggle_panel,
    toggle_handout,
    toggle_error_map,
    toggle_brush,
    toggle_wipe,
    swap_wipe,
    save_picture,
    save_map,      ///< the map that the lab makes
    save_heights,  ///< the heights that the lab shows
    edit_error,
};

/// The switches over the two have no default, so that the compiler names an action that one of them forgets.
using MenuAction = std::variant<WindowAction, LabAction>;

struct MenuWish {
    std::vector<MenuAction> actions = {};  ///< in the order of the keys
    const LabEntry* lab = nullptr;
    std::optional<std::string> check = {};  ///< show this check; "": the picture again
    std::string knob = {}, probe = {};      ///< show the slider of this knob; show this probe
    std::string value = {};                 ///< set `knob` to this value
    std::string document = {};              ///< show this document of the course beside the picture, and in it
    std::string passage = {};               ///< this heading or word
    Place edit = {};                        ///< open this place in the editor
    std::string message = {};               ///< show this in the status line
    float scroll = 0;                       ///< scroll the handout by this many lines
    int columns = 0, rows = 0;              ///< move the mark of the search or the start page

    void ask(MenuAction action) { actions.push_back(action); }
    bool is_empty() const {
        return actions.empty() && !lab && !check && knob.empty() && probe.empty() && edit.file.empty() &&
               document.empty() && message.empty() && scroll == 0 && columns == 0 && rows == 0;
    }
};

}  // namespace relief::window
