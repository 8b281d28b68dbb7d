// The lab's checks in the window: run one at a time, and again when a file was saved. In the window module only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/check/check.h"

namespace relief {

/// How far a task is.
enum class TaskState { waiting, passed, wrong, unfinished };

class Checks {
public:
    Checks() = default;
    Checks(const Checks&) = delete;
    Checks& operator=(const Checks&) = delete;

    /// Of this lab from now on; all of them wait.
    void open(const LabEntry& lab, const Manifest& manifest);

    /// Looks whether a file that a check can depend on was saved; then all checks wait again. Call it a few times a
    /// second: files count when two calls in a row saw them the same. Returns whether there is anything new to show.
    bool look();
    bool pending() const;
    /// Runs one that waits, that of this name before all others, in the current context and in targets of its own.
    /// Takes as long as `relief check` takes for that check.
    void run_next(const std::string& first);

    const LabEntry& lab() const { return *lab_; }
    const Manifest& manifest() const { return manifest_; }
    /// In the manifest's order. Nothing while a check waits for its first run; until it has run again the old result
    /// stays.
    const std::optional<CheckResult>& result(size_t check) const { return results_[check]; }
    /// Whether it is still to be run, so that result() is that of older files.
    bool waits(size_t check) const { return waiting_[check]; }
    /// How many have a result, and whether all have one.
    size_t count() const;
    bool is_whole() const { return count() == results_.size(); }
    TaskState state(const TaskInfo& task) const;
    double points(const TaskInfo& task) const;
    double points() const;
    /// The hint of the known mistake that the task's pictures show; empty if none is known, or not all checks have run.
    std::string mistake(const TaskInfo& task) const;
    /// Counts the runs of each check and all their changes: what was made from a result holds while it is the same.
    int version() const { return version_; }

    /// A file of C++ that was saved while the window was open, which only a build takes in; empty if there is none.
    const std::string& to_build() const { return to_build_; }

private:
    using Files = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    Files files() const;

    const LabEntry* lab_ = nullptr;
    Manifest manifest_;
    std::optional<LabChecker> checker_;
    std::vector<std::optional<CheckResult>> results_;
    std::vector<std::optional<Image>> expected_;  ///< what no file of a student's can change
    std::vector<bool> waiting_;
    std::map<std::string, std::string> mistakes_;  ///< by task
    int version_ = 0;
    Files seen_, last_look_;
    std::string to_build_;
};

}  // namespace relief
