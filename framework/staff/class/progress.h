// The progress of a class: which of its submissions have a valid result.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/staff/class/roster.h"
#include "framework/staff/grade/results.h"

namespace relief::grade {

/// Returns FOLDER/results/NAME.json.
std::filesystem::path result_file(const std::filesystem::path& folder, const std::string& name);

/// Returns the result of a submission in `folder`. Returns nothing if it is missing, damaged, or of another course or
/// seed, or if the machine failed on it.
std::optional<SubmissionMark> result_of(const std::filesystem::path& folder, const std::string& name,
                                        const std::string& course);

struct ClassProgress {
    Roster roster;
    std::vector<std::optional<SubmissionMark>> marks;  ///< one for each submission of the roster

    size_t results() const;
    std::vector<std::string> without_result() const;
};

/// Reads the progress of a class in `folder`, or in its subfolders (parts). Throws UsageError if there is no class.
ClassProgress read_progress(const std::filesystem::path& folder);

/// Returns some of the names: "jane, joe and 3 more".
std::string some_of(const std::vector<std::string>& names);

}  // namespace relief::grade
