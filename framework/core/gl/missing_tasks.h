// Controls whether probes show that a task is missing.
#pragma once

namespace relief {

/// While an object of this class exists, probes return `not_written` where their value depends on a task that is not
/// written: for the window and printed figures. Otherwise, or if `tell` is false, probes use the task's stand-in value:
/// for checks of other tasks.
class TellMissingTasks {
public:
    explicit TellMissingTasks(bool tell = true);
    ~TellMissingTasks();
    TellMissingTasks(const TellMissingTasks&) = delete;
    TellMissingTasks& operator=(const TellMissingTasks&) = delete;

private:
    bool before_;
};

bool missing_tasks_are_told();

}  // namespace relief
