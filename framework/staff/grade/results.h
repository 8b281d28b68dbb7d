// The results of grading: a JSON file for each submission, which is the grader's verdict.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/staff/grade/marks.h"

namespace relief {

/// Everything known about a graded submission.
struct SubmissionMark {
    std::string name;
    std::string hash, course;  ///< hashes of the submission and the course: if both hold, it is not graded again
    std::string isolation;     ///< "namespaces" or "limits"
    std::string problem;       ///< why nothing could be read, or empty
    std::vector<std::string> ignored;
    size_t ignored_count = 0;
    std::vector<LabMark> labs;
    double seconds = 0;  ///< from reading the submission to its mark

    double points() const;
    int max_points() const;
    /// No check failed through the grader's fault.
    bool graded() const;
    const LabMark* lab(const std::string& folder) const;
};

/// A safe file name for any name. A name of plain characters stays as it is; in any other, characters are replaced and
/// a part of its hash is appended.
std::string file_name_of(const std::string& name);

/// `check.found`, as far as its student may read it: nothing about a hidden check; about a hidden view only that it was
/// one.
std::string found_for_students(const CheckMark& check);

/// The complete result, schema 1. from_json() throws Error for anything else, and if the points do not follow from the
/// checks.
std::string to_json(const SubmissionMark& mark);
SubmissionMark from_json(const std::string& text);

}  // namespace relief
