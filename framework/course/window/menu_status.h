// The line at the bottom of the window: frame time, counters, messages, camera. In the window module only.
#pragma once

#include <array>
#include <string>

#include "framework/course/window/menu_layout.h"

namespace relief::window {

class Stage;

class Status {
public:
    /// Records the time of a frame. Call it once for each frame of the lab.
    void note(double milliseconds);
    void draw(const Box& box, float scale, const Stage& stage, const std::string& message) const;

private:
    std::array<float, 60> milliseconds_{};  ///< the newest last
};

}  // namespace relief::window
