// A class: every submission marked, several at a time, each result kept as soon as it is known.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/grade/results.h"

namespace relief {

struct ClassOptions {
    std::vector<std::filesystem::path> submissions;
    std::filesystem::path output;
    std::vector<const LabEntry*> labs;  ///< none: in each submission those that it has a file of
    int jobs = 1;
    bool trust = false;  ///< grade also where a submission cannot be kept from the rest of the machine
    bool fresh = false;  ///< grade everything anew
    GradeLimits limits;
};

struct ClassReport {
    std::vector<SubmissionMark> marks;  ///< in the order of the submissions
    IsolationReport isolation;
    size_t taken_over = 0;             ///< not graded again, since nothing has changed
    double prepared = 0, seconds = 0;  ///< for the solutions, and in all
    MarkTimes times;
};

/// How submissions may be run here. Throws Error where they can be kept from nothing and `trust` is not given.
IsolationReport isolation_for(bool trust);

/// Writes into `output`: results/NAME.json as each is done, then results.csv, junit.xml, report.html,
/// gradescope/NAME.json. Throws
/// UsageError for two submissions of one name and for none, Error where the solutions themselves do not pass here.
ClassReport grade_class(const ClassOptions& options);

}  // namespace relief
