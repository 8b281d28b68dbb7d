// The lab's checks in the window: run one at a time, and again after a file is saved. In the window module only.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/check/check.h"

namespace relief::window {

class Checks {
public:
    Checks() = default;
    Checks(const Checks&) = delete;
    Checks& operator=(const Checks&) = delete;

    /// When the files were saved that a lab's checks depend on.
    using Files = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    static Files files(const LabEntry& lab, const Manifest& manifest);

    /// Switches to the checks of this lab; all of them wait.
    void open(const LabEntry& lab, const Manifest& manifest);

    /// Deletes the results and all objects of the lab.
    void close() { lab_ = nullptr, checker_.reset(), results_.clear(), expected_.clear(), waiting_.clear(); }

    /// Marks all checks as waiting if a file that they depend on was saved. Call it a few times a second: a change
    /// counts after two calls in a row have seen the same files. Returns whether there is anything new to show.
    bool look();
    bool pending() const;
    /// Runs one waiting check, preferably the one named `first`, in the current context and its own targets. Takes as
    /// long as `relief check` takes for that check.
    void run_next(const std::string& first);

    bool is_of(const LabEntry& lab) const { return lab_ == &lab; }
    const LabEntry& lab() const { return *lab_; }
    const Manifest& manifest() const { return manifest_; }
    /// Returns the result of a check, indexed in the manifest's order. Empty before the first run. The old result stays
    /// until the check has run again.
    const std::optional<check::Verdict>& result(size_t check) const { return results_[check]; }
    /// Returns whether the check has yet to run, so that result() is out of date.
    bool waits(size_t check) const { return waiting_[check]; }
    /// Returns how many checks are up to date: "3 of 12".
    std::string progress() const;
    /// Returns the worst outcome of a task's checks; nothing until all have run.
    std::optional<check::Outcome> worst(const TaskInfo& task) const;
    /// Its checks without their pictures; one that has not run yet is unfinished.
    check::TaskVerdict of(const TaskInfo& task) const;
    std::vector<check::TaskVerdict> tasks() const;
    /// Returns the points of the lab, as `relief check` prints them.
    std::string points() const;
    /// Returns the hint of the known mistake that the task's pictures show. Empty if none is known, or if some checks
    /// have not run.
    std::string hint(const TaskInfo& task) const;
    /// Grows with each run of a check and each change. Anything derived from a result is valid as long as it stays the
    /// same.
    int version() const { return version_; }

    /// A C++ file that was saved while the window was open and needs a build; empty if there is none.
    const std::string& to_build() const { return to_build_; }

private:
    const LabEntry* lab_ = nullptr;
    Manifest manifest_;
    std::optional<check::LabChecker> checker_;
    std::vector<std::optional<check::Verdict>> results_;
    std::vector<std::optional<Image>> expected_;  ///< pictures that do not depend on a student's files
    std::vector<bool> waiting_;
    std::map<std::string, std::string> hints_;  ///< of known mistakes, by task
    int version_ = 0;
    Files seen_, last_look_;
    std::filesystem::file_time_type saved_;  ///< check::last_saved() before the checks that run started
    std::string to_build_;
};

}  // namespace relief::window
