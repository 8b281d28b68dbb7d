// The log of graded hand-ins, marks/hand_ins/NAME.csv, and the marks that a hand-in beyond the limit keeps.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/staff/class/point_in_time.h"
#include "framework/staff/grade/results.h"

namespace relief::grade {

struct GradedHandIn {
    std::string lab;    ///< folder
    Moment graded_at;   ///< when the run began that graded it, by the machine's clock
    std::string files;  ///< hash of the lab's task files
};

/// Reads the log of a submission in the folder of results, the oldest hand-in first. Empty if there is none. Throws
/// Error with file and line for an invalid row.
std::vector<GradedHandIn> read_hand_in_log(const std::filesystem::path& folder, const std::string& name);

/// Appends hand-ins to the log of a submission.
void log_hand_ins(const std::filesystem::path& folder, const std::string& name, const std::vector<GradedHandIn>& more,
                  UtcOffset offset);

/// Returns the last graded hand-in of a lab, or null.
const GradedHandIn* last_hand_in(const std::vector<GradedHandIn>& log, const std::string& lab);

/// Returns the number of hand-ins of a lab that were graded on the day of `moment`.
int hand_ins_on_day(const std::vector<GradedHandIn>& log, const std::string& lab, Moment moment, UtcOffset offset);

/// Returns the last marks of all labs of a submission that were graded in this folder under a limit. Nothing if there
/// are none, or if they are of another course or seed.
std::optional<SubmissionMark> earlier_marks(const std::filesystem::path& folder, const std::string& name,
                                            const std::string& course);

/// Keeps the marks for earlier_marks(). Labs that `mark` lacks stay as they are.
void keep_marks(const std::filesystem::path& folder, const SubmissionMark& mark);

}  // namespace relief::grade
