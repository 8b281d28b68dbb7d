// How far a class is: which of its submissions have a result that holds.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/staff/grade/results.h"
#include "framework/staff/grade/roster.h"

namespace relief {

/// FOLDER/results/NAME.json
std::filesystem::path result_file(const std::filesystem::path& folder, const std::string& name);

/// The result of a submission in `folder`; nothing if there is none, if it is of another course or seed, if the machine
/// failed on it, or if it is damaged.
std::optional<SubmissionMark> result_of(const std::filesystem::path& folder, const std::string& name,
                                        const std::string& course);

struct ClassProgress {
    Roster roster;
    std::vector<std::optional<SubmissionMark>> marks;  ///< one for each submission of the roster

    size_t results() const;
    std::vector<std::string> without_result() const;
    std::vector<SubmissionMark> take_marks() &&;
};

/// Of a class in `folder`, or in folders in it (parts). Throws UsageError if there is none.
ClassProgress read_progress(const std::filesystem::path& folder);

/// "jane, joe and 3 more"
std::string some_of(const std::vector<std::string>& names);

}  // namespace relief
