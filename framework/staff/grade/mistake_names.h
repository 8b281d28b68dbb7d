// Recognises the known mistake in the pictures of a failed task.
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/check/fingerprints.h"
#include "framework/course/check/judge.h"
#include "framework/staff/grade/check_views.h"
#include "framework/staff/grade/fingerprint_maker.h"

namespace relief::grade {

/// The known mistakes of one lab. Each is drawn once, when a submission first needs it. Thread-safe.
class MistakeNames {
public:
    /// `solution`: the solution's pictures in the checks' own views.
    MistakeNames(const LabViews& views, const DrawnChecks& solution);

    /// Returns the mistake that the task's pictures show, see check::name_mistakes(). `compared`: for each check,
    /// whether its picture may be compared. It may not if the check was not drawn, or if another task may have spoilt
    /// it.
    std::optional<check::NamedMistake> name(const std::string& task, const std::vector<check::Verdict>& said,
                                            const DrawnChecks& drawn, const std::vector<bool>& compared) const;

private:
    /// The fingerprints of a task, in the making until all its mistakes are drawn.
    struct OfTask {
        std::vector<const MistakeInfo*> mistakes = {};
        std::vector<DrawnProgram> drawn = {};
        size_t next = 0, done = 0;
        check::Fingerprints prints = {};
        std::condition_variable made = {};
    };

    const check::Fingerprints& fingerprints(const std::string& task) const;
    DrawnProgram draw(const MistakeInfo& mistake) const;

    const LabViews& views_;
    mutable std::mutex mutex_;
    mutable std::map<size_t, check::Sample> solution_;  ///< by check, of the tasks without fingerprints
    mutable std::map<std::string, OfTask> by_task_;
};

}  // namespace relief::grade
