// The results of grading: a JSON file for each submission, with the grader's verdict.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/staff/grade/marks.h"

namespace relief::grade {

/// Everything known about a graded submission.
struct SubmissionMark {
    std::string name;
    std::string hash, course;  ///< hashes of the submission and the course: if both match, it is not graded again
    std::string isolation;     ///< "namespaces" or "limits"
    std::string problem;       ///< why nothing could be read, or empty
    std::vector<std::string> ignored;
    size_t ignored_count = 0;
    std::vector<std::string> remarks = {};  ///< printable: which of several files counts, which has a wrong name
    std::vector<LabMark> labs;
    double seconds = 0;  ///< seconds from reading the submission to its mark

    double points() const;
    int max_points() const;
    /// Returns whether no check failed through the grader's fault.
    bool graded() const;
    const LabMark* lab(const std::string& folder) const;
};

/// Returns a safe file name for any name. Plain names stay unchanged. In other names, characters are replaced, and a
/// part of the name's hash is appended.
std::string file_name_of(const std::string& name);

/// Returns the part of `check.found` that the student may read: nothing for a hidden check; for a hidden view only the
/// fact that it was hidden.
std::string found_for_students(const check::Verdict& check);

/// Convert the complete result, schema 1. from_json() throws Error for any other text, and if the points do not follow
/// from the checks.
std::string to_json(const SubmissionMark& mark);
SubmissionMark from_json(const std::string& text);

}  // namespace relief::grade
