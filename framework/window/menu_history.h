// What was set before: undo and redo of knobs, camera and probe. In the window module only.
#pragma once

#include <optional>
#include <vector>

#include "framework/lab/shot.h"

namespace relief {

class History {
public:
    /// Another lab: nothing to go back to.
    void begin(Shot now);
    /// Call it when a setting is reached: the mouse is up and nothing is typed. One that differs from the last one is
    /// a step.
    void note(const Shot& now);
    /// The setting before or after; nothing where there is none.
    std::optional<Shot> undo();
    std::optional<Shot> redo();

private:
    std::vector<Shot> steps_;
    size_t at_ = 0;  ///< of the present one
};

}  // namespace relief
