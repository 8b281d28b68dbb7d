// Undo and redo of knobs, camera and probe. In the window module only.
#pragma once

#include <optional>
#include <vector>

#include "framework/core/lab/shot.h"

namespace relief::window {

class History {
public:
    /// Starts a new history, for another lab.
    void begin(Shot now);
    /// Adds a step if the setting differs from the current step. Call it when a setting is complete: the mouse is up
    /// and nothing is being typed.
    void note(const Shot& now);
    /// Moves to the step before or after and returns it; nothing if there is none.
    std::optional<Shot> undo();
    std::optional<Shot> redo();

private:
    std::vector<Shot> steps_;
    size_t at_ = 0;  ///< index of the current step
};

}  // namespace relief::window
