// Names the known mistake that the pictures of a failed task show.
#pragma once

#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "framework/check/likeness.h"
#include "framework/staff/grade/check_views.h"

namespace relief {

/// The hint of a known mistake, with those of the mistakes that are `same_as` it.
std::string hint_with_same(const Manifest& manifest, const MistakeInfo& mistake);

struct NamedMistake {
    std::string id;
    std::string hint;  ///< see hint_with_same()
};

/// The known mistakes of one lab. Each is drawn once, when a submission needs it. Threads may share it.
class MistakeNames {
public:
    /// `solution`: what the solution draws in the checks' own views.
    MistakeNames(const LabViews& views, const DrawnChecks& solution);

    /// The mistake that agrees best with what was drawn for the task's checks, if it agrees with nine tenths of what
    /// differs from the solution; else nothing. `compared`: by check, whether its pictures may be compared. A check is
    /// left out if it was not drawn, or if another task may have spoilt it.
    std::optional<NamedMistake> name(const std::string& task, const DrawnChecks& drawn,
                                     const std::vector<bool>& compared) const;

private:
    /// What a mistake draws in its task's checks.
    struct Signature {
        const MistakeInfo* mistake;
        Samples samples = {};
    };
    struct Signatures {
        std::vector<Signature> list;
        size_t next = 0, done = 0;
        std::condition_variable one_more;
    };

    const std::vector<Signature>& signatures(const std::string& task) const;
    Samples samples_of(const MistakeInfo& mistake) const;
    double agreement(const Signature& signature, const std::vector<Sample>& drawn,
                     const std::vector<bool>& compared) const;

    const LabViews& views_;
    std::vector<Sample> solution_;  ///< by check
    mutable std::mutex mutex_;
    mutable std::map<std::string, Signatures> by_task_;
};

}  // namespace relief
