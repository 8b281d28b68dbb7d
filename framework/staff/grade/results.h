// What grading leaves behind: a JSON file for each submission, and what others read of them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/staff/grade/marks.h"

namespace relief {

/// All that is known of a graded submission.
struct SubmissionMark {
    std::string name, hash, course;  ///< the hashes say when it need not be graded again
    std::string isolation;           ///< "namespaces" or "limits"
    std::string problem;             ///< why nothing could be read, or empty
    std::vector<std::string> ignored;
    size_t ignored_count = 0;
    std::vector<LabMark> labs;
    double seconds = 0;  ///< from reading it to its mark

    double points() const;
    int max_points() const;
    /// No check failed through the grader's fault.
    bool graded() const;
    const LabMark* lab(const std::string& folder) const;
};

/// A file name for any name: the name itself when it is plain, else what is plain of it and a part of its hash.
std::string file_name_of(const std::string& name);

/// What was found, as far as its student may read it: of a hidden check nothing, and of a hidden view that it was one.
std::string found_for_students(const CheckMark& check);

/// The whole of it, schema 1. The other way throws Error for what is not that, and for points that do not come of its
/// checks.
std::string to_json(const SubmissionMark& mark);
SubmissionMark from_json(const std::string& text);

/// Gradescope's results.json: hidden checks stay hidden from the student.
std::string to_gradescope(const SubmissionMark& mark);
/// A line for each submission: name, points, a column for each task that any of them has.
std::string to_csv(const std::vector<SubmissionMark>& marks);
/// A suite for each submission, a case for each check.
std::string to_junit(const std::vector<SubmissionMark>& marks);
/// A table for a terminal.
std::string to_table(const std::vector<SubmissionMark>& marks);

}  // namespace relief
