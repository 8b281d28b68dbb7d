// Transplants one task of a submission into the course's own files, so that mistakes in other tasks cost it no points.
#pragma once

#include <optional>
#include <string>

namespace relief::grade {

/// Returns the task file `solution` with the part for `task` ("11.2") replaced by the part in `submitted`; see
/// task_parts(). Also takes the text before the first task from the submission, because all its tasks may use it. The
/// submitted part may use functions, constants, types and macros from the part of another task. These are added to the
/// solution of that other task, unless the solution defines the same name or that part contains a directive such as
/// `#if`. Returns nothing if the submission does not have the task's line.
std::optional<std::string> with_one_task(const std::string& solution, const std::string& submitted,
                                         const std::string& task);

}  // namespace relief::grade
