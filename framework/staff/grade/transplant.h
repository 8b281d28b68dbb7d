// Transplants one task of a submission into the course's own files, so that mistakes in other tasks cost it no points.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"

namespace relief::grade {

/// Returns the text of `submitted`, a task file, with the functions of all tasks but `task` ("11.2") replaced by those
/// of `solution`. Keeps the other code that the task's functions use, directly or not. Of the rest, a definition that
/// the solution has too becomes the solution's, and any other goes. A function that the submission lacks is added.
/// `tasks`: all tasks of the lab. Returns nothing if the submission lacks a function of the task.
std::optional<std::string> with_one_task(const std::string& solution, const std::string& submitted,
                                         const std::vector<TaskInfo>& tasks, const TaskInfo& task);

/// Returns the task file without the definitions of the task's functions.
std::string without_task(const std::string& solution, const std::vector<TaskInfo>& tasks, const TaskInfo& task);

}  // namespace relief::grade
