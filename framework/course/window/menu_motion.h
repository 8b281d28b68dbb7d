// Motion in the window: the camera turns, or a slider runs over its range, such as the direction of a lamp. It is off
// until the user asks for it, and no screenshot has it. In the window module only.
#pragma once

#include <string>

namespace relief::window {

class Stage;

class Motion {
public:
    bool is_on() const { return turns_ || !slider_.empty(); }
    void stop() { turns_ = false, slider_.clear(); }
    /// Lets the camera turn, or stops it.
    void toggle_camera() { turns_ = !turns_; }
    /// Lets this slider run in place of another one, or stops it.
    void toggle_slider(const std::string& name) { slider_ = slider_ == name ? "" : name; }
    /// Name of the running slider, or empty.
    const std::string& slider() const { return slider_; }

    /// Moves the camera and the slider on by this time.
    void advance(Stage& stage, double seconds);

private:
    bool turns_ = false;
    std::string slider_;
    double direction_ = 1;  ///< of a slider that turns round at its ends
};

}  // namespace relief::window
