// Recognises the known mistake in the pictures of a failed task.
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/check/likeness.h"
#include "framework/staff/grade/check_views.h"

namespace relief::grade {

/// Returns the hint of a known mistake, joined with the hints of mistakes that are `same_as` it.
std::string hint_with_same(const Manifest& manifest, const MistakeInfo& mistake);

struct NamedMistake {
    std::string id;
    std::string hint;  ///< see hint_with_same()
};

/// The known mistakes of one lab. Each is drawn once, when a submission first needs it. Thread-safe.
class MistakeNames {
public:
    /// `solution`: the solution's pictures in the checks' own views.
    MistakeNames(const LabViews& views, const DrawnChecks& solution);

    /// Returns the mistake that agrees best with the pictures of the task's checks. Considers only mistakes that match
    /// in every compared check (see is_like()); returns nothing if there is none. `compared`: for each check, whether
    /// its pictures may be compared. They may not if the check was not drawn, or if another task may have spoilt it.
    std::optional<NamedMistake> name(const std::string& task, const DrawnChecks& drawn,
                                     const std::vector<bool>& compared) const;

private:
    /// Samples of a mistake's pictures in its task's checks.
    struct Signature {
        const MistakeInfo* mistake;
        check::Samples samples = {};
    };
    struct Signatures {
        std::vector<Signature> list;
        size_t next = 0, done = 0;
        std::condition_variable one_more;
    };

    const std::vector<Signature>& signatures(const std::string& task) const;
    check::Samples samples_of(const MistakeInfo& mistake) const;
    double agreement(const Signature& signature, const std::vector<check::Sample>& drawn,
                     const std::vector<bool>& compared) const;

    const LabViews& views_;
    std::vector<check::Sample> solution_;  ///< by check
    mutable std::mutex mutex_;
    mutable std::map<std::string, Signatures> by_task_;
};

}  // namespace relief::grade
