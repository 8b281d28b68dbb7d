// A class: every submission marked, several at a time, each result kept as soon as it is known.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "framework/base/descriptor.h"
#include "framework/staff/grade/results.h"
#include "framework/staff/grade/roster.h"

namespace relief {

struct ClassOptions {
    std::vector<std::filesystem::path> submissions;
    std::filesystem::path output;
    std::vector<const LabEntry*> labs;  ///< none: in each submission those that it has a file of
    int jobs = 1;
    bool trust = false;  ///< grade also where a submission cannot be kept from the rest of the machine
    bool fresh = false;  ///< grade everything anew
    /// Its isolation is found out. Without a seed: that of an earlier run into `output`, or one that nobody could know.
    GradeSetup setup;
    Shard shard;  ///< only these submissions
};

struct ClassReport {
    std::vector<SubmissionMark> marks;  ///< in the order of the submissions
    IsolationReport isolation;
    std::string seed;
    size_t taken_over = 0;             ///< not graded again, since nothing has changed
    double prepared = 0, seconds = 0;  ///< for the solutions, and in all
    MarkTimes times;
};

/// Keeps other graders out of a folder as long as it is open, however this one ends. Parts of a class may be graded
/// into one folder at a time: what is not of one class merge_class() finds. Throws Error when another grader is at work
/// in it. Nothing is left in the folder.
Descriptor hold_output(const std::filesystem::path& folder, const Shard& shard);

/// A seed that nobody could know.
std::string new_seed();

/// How submissions may be run here. Throws Error where they can be kept from nothing and `trust` is not given.
IsolationReport isolation_for(bool trust);

/// Called when a submission has its mark, by the thread that graded it, several at a time; the pictures are gone after
/// it.
using SubmissionDone = std::function<void(const SubmissionMark&, const std::vector<CheckPictures>&)>;

/// Writes into `output`: class.json, and results/NAME.json as each is done, when `done` has returned. Throws UsageError
/// for two submissions of one name, for none, and for a shard without a seed; Error where the solutions themselves do
/// not pass here; and what `done` throws.
ClassReport grade_class(const ClassOptions& options, const SubmissionDone& done = {});

}  // namespace relief
