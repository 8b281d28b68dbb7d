// The points of a lab's last checks, kept for `relief list`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/core/lab/registry.h"
#include "framework/course/check/verdict.h"

namespace relief::check {

/// Keeps the points of a lab whose checks have all run, in the course's build folder. Does nothing if that is not
/// writable.
void keep_points(const LabEntry& lab, const std::vector<TaskVerdict>& tasks);

/// Returns the points that were kept, with a plus before optional ones: "4.25", "11 + 2". Returns nothing if a file of
/// a task is newer.
std::optional<std::string> last_points(const LabEntry& lab, const Manifest& manifest);

}  // namespace relief::check
