// Writes an autograder for Gradescope: the course with its solutions, and the two scripts that Gradescope runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {
struct LabEntry;
}

namespace relief::grade {

/// Writes setup.sh, run_autograder and course/ into a folder. Throws UsageError unless the folder is new, empty, or
/// written by an earlier call. `labs`: grade only these; empty: the labs whose files a submission has.
void write_gradescope(const std::filesystem::path& folder, const std::vector<const LabEntry*>& labs,
                      const std::string& seed);

}  // namespace relief::grade
