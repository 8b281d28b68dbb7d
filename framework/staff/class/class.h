// Grades a class, several submissions at a time. Writes each result as soon as it is known.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "framework/core/base/descriptor.h"
#include "framework/staff/class/point_in_time.h"
#include "framework/staff/class/roster.h"
#include "framework/staff/grade/results.h"

namespace relief::grade {

struct ClassOptions {
    std::vector<std::filesystem::path> submissions;
    std::filesystem::path output;
    std::vector<const LabEntry*> labs;  ///< empty: for each submission the labs whose files it has
    int jobs = 1;                       ///< number of submissions at a time
    bool trust = false;                 ///< grade even if submissions cannot be isolated
    bool fresh = false;                 ///< grade everything again
    /// Keep class.json in `output`, and grade its submissions that have no result yet.
    bool keep_roster = false;
    /// `isolation` is ignored: it is probed. With an empty seed the seed of an earlier run into `output` is used, else
    /// a random one.
    GradeSetup setup;
    Shard shard;  ///< only these submissions
    /// The day of this moment counts for the limit of hand-ins in the class file.
    Moment now = std::chrono::floor<std::chrono::seconds>(std::chrono::system_clock::now());
};

struct ClassReport {
    std::vector<SubmissionMark> marks;  ///< in the order of the submissions
    /// Submissions in class.json that cannot be read here. They have no mark.
    std::vector<std::string> lost;
    /// Names that several submissions share. These submissions are not graded, and a message has named them.
    std::vector<std::string> doubled;
    IsolationReport isolation;
    std::string seed;
    size_t taken_over = 0;             ///< number of submissions unchanged since an earlier run, so not graded again
    double prepared = 0, seconds = 0;  ///< seconds for the solutions, and in total
    MarkTimes times;                   ///< sum over all jobs
};

enum class Hold { alone, as_part };

/// Locks a folder against other graders until the descriptor is closed or this process ends. Hold::as_part lets several
/// parts of a class be graded into one folder at a time; merge_class() detects parts of different classes. Throws Error
/// if another grader has locked the folder. Leaves no file behind.
Descriptor hold_output(const std::filesystem::path& folder, Hold hold);

/// Returns a random seed of 128 bits. Results hold a hash of course and seed, so the seed must be too long to guess.
std::string new_seed();

/// Returns the isolation that this machine offers. Throws Error if there are no namespaces and `trust` is false.
IsolationReport isolation_for(bool trust);

/// Called after a submission is graded, by the thread that graded it: several calls can run at a time. The pictures are
/// freed after the call.
using SubmissionDone = std::function<void(const SubmissionMark&, const std::vector<CheckPictures>&)>;

/// Reads all submissions and writes class.json into `output`, but grades none. class.json includes the processor time
/// of the solutions if this machine can draw them. Removes outdated results; the remaining ones are valid. Throws
/// UsageError as grade_class() does.
void enlist_class(const ClassOptions& options);

/// Writes class.json into `output`, and results/NAME.json of each submission after `done` has returned for it. If the
/// class file of `output` limits hand-ins, a lab beyond the limit keeps its earlier mark, see hand_in_log.h. Throws
/// UsageError if there are no submissions, or for a shard without a seed. Throws Error if a lab's own solution fails on
/// this machine, or if `keep_roster` is set and class.json is of another course. Propagates exceptions of `done`.
ClassReport grade_class(const ClassOptions& options, const SubmissionDone& done = {});

}  // namespace relief::grade
