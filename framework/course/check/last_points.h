// The points of a lab's last checks, kept for `relief list`.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/core/lab/registry.h"
#include "framework/course/check/verdict.h"

namespace relief::check {

/// Returns when a file of the lab's tasks was saved last. Call it before the checks start: a file that is saved while
/// they run may not have been checked.
std::filesystem::file_time_type last_saved(const Manifest& manifest);

/// Keeps the points of a lab whose checks have all run, in the course's build folder; `saved`: last_saved() before
/// they started. Does nothing if the folder is not writable.
void keep_points(const LabEntry& lab, const std::vector<TaskVerdict>& tasks, std::filesystem::file_time_type saved);

/// Returns the points that were kept, with a plus before optional ones: "4.25", "11 + 2". Returns nothing if a file of
/// a task was saved since the checks started.
std::optional<std::string> last_points(const LabEntry& lab, const Manifest& manifest);

}  // namespace relief::check
