// An autograder for Gradescope: the course with its solutions, and the two scripts that Gradescope runs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace relief {

struct LabEntry;

/// Writes setup.sh, run_autograder and course/ into a folder: new, empty, or one that it wrote before. `labs`: only
/// these are graded; none: those that a submission has a file of. Throws UsageError for any other folder.
void write_gradescope(const std::filesystem::path& folder, const std::vector<const LabEntry*>& labs,
                      const std::string& seed);

}  // namespace relief
