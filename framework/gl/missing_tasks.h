// Whether probes tell that a task is missing.
#pragma once

namespace relief {

/// While one lives, probes hold not_written where their value comes from a task that is not written: for people, and for
/// figures. Without one, or with `tell` false, they hold what stands in for it, as checks of other tasks need it.
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
