// The window while one lab is open: its picture with all that stands around and over it. In the window module only.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/course/window/menu_brush.h"
#include "framework/course/window/menu_check_view.h"
#include "framework/course/window/menu_checks.h"
#include "framework/course/window/menu_error.h"
#include "framework/course/window/menu_error_map.h"
#include "framework/course/window/menu_explain.h"
#include "framework/course/window/menu_handout.h"
#include "framework/course/window/menu_history.h"
#include "framework/course/window/menu_keys.h"
#include "framework/course/window/menu_layout.h"
#include "framework/course/window/menu_motion.h"
#include "framework/course/window/menu_panel.h"
#include "framework/course/window/menu_pixel.h"
#include "framework/course/window/menu_stage.h"
#include "framework/course/window/menu_status.h"
#include "framework/course/window/menu_wipe.h"

namespace relief::window {

/// The time of an animated lab, in seconds since it was opened, without the pauses.
class Clock {
public:
    void restart() { *this = {}; }
    void toggle() { is_paused_ = !is_paused_; }
    bool is_paused() const { return is_paused_; }
    double time() const { return time_; }
    /// Goes on to `now`, a time of any clock, and returns the seconds since the last call; 0 for the first one.
    double advance(double now);

private:
    bool is_paused_ = false;
    double time_ = 0, last_ = -1;
};

class LabView {
public:
    /// Opens a lab. `start` replaces the manifest's knobs, camera and probe.
    void open(const LabEntry& entry, const Shot* start = nullptr);
    const Stage& stage() const { return stage_; }
    const Checks& checks() const { return checks_; }

    /// Returns whether each frame of the window shows another picture.
    bool moves() const;
    /// Returns whether exact values are being computed on another thread.
    bool computes() const { return error_map_.computes(); }
    /// Looks for saved files. Returns whether there is anything new to show.
    bool look_at_files();
    /// Computes what waits for a still picture: the explanation of a pixel, the error map. Call it between two frames.
    /// Returns whether there is anything new to show.
    bool compute(bool is_dragged);
    /// Returns whether to run a check now.
    bool has_check_to_run() const;
    void run_check() { checks_.run_next(check_view_.name()); }

    /// Gives the keys back to the lab.
    void leave_parts();
    /// Adds the lab's open parts.
    void add_open_parts(OpenParts& open) const;
    /// Carries out the wishes for the lab in this order: actions, check, probe, value, editor, knob.
    void act(const MenuWish& wish);
    void show_check(const std::string& name);
    /// Loads a picture or a model that was dropped on the window.
    void take(const std::filesystem::path& file);

    /// Draws everything but the interface of Dear ImGui, which it only describes, into the window. Returns how many
    /// more frames this one needs.
    int draw(glm::ivec2 window, float scale, bool is_dragged, MenuWish& wish);
    /// Returns the part of the window for the picture, in the last frame.
    const Box& picture() const { return picture_; }

private:
    void act(LabAction action);
    void act_mouse();
    void draw_parts(const Layout& layout, float scale, MenuWish& wish);
    int draw_picture(glm::ivec2 room, float scale);
    glm::ivec2 room() const;
    glm::dvec2 pixel_under_mouse() const;
    void set(const std::string& knob, const std::string& value);
    void explain_pixel();
    void undo(bool again);
    void toggle_wipe();
    std::vector<std::string> parts_with_keys() const;
    void take_next_part();
    void let_go_of_keys();
    void draw_part_frame(const Layout& layout, float scale);

    Stage stage_;
    Checks checks_;
    CheckView check_view_;
    Panel panel_;
    Status status_;
    Borders borders_;
    ErrorBox error_box_;
    Motion motion_;
    History history_;
    Wipe wipe_;
    Brush brush_;
    Handout handout_;
    ErrorMap error_map_;
    PixelValues pixel_;
    PixelExplanation explanation_;
    Clock clock_;
    Box picture_;
    double opened_ = 0, drawn_ = 0;  ///< when the lab was opened and its picture was drawn; infinite: not yet
    bool is_panel_hidden_ = false;
    bool is_told_ = false;  ///< the note about a slow frame is on screen
    std::string message_;
    std::string part_;  ///< the part of the window that has the keys, by the name of its ImGui window; else empty
};

}  // namespace relief::window
