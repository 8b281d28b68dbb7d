// Undo and redo of knobs, camera and probe. In the window module only.
#pragma once

#include <vector>

#include "framework/core/lab/shot.h"

namespace relief::window {

class Stage;

class History {
public:
    /// Starts a new history, for another lab.
    void begin(const Stage& stage);
    /// Adds a step if the stage's setting has changed since the last step. Call it when a setting is complete: the
    /// mouse is up and nothing is being typed.
    void note(const Stage& stage);
    /// Applies the setting of the step before or after, if there is one.
    void undo(Stage& stage);
    void redo(Stage& stage);

private:
    void go(Stage& stage, size_t step);

    std::vector<Shot> steps_;
    size_t at_ = 0;      ///< index of the current step
    int64_t edits_ = 0;  ///< edits of the stage at the current step
};

}  // namespace relief::window
