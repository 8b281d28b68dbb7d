// One task of a submission in the course's own files, so that it is marked apart from mistakes in other tasks.
#pragma once

#include <optional>
#include <string>

namespace relief {

/// `solution`, the text of a task file, with the part of `submitted` that is about `task` ("11.2") in place of its own.
/// See task_parts(). The text before the first task is the submission's: it may hold what all its tasks use. So are
/// functions, constants, types and macros that the task's part uses and that the submission has in the part of another
/// task: they are added to the solution of that task, unless the solution has the same name, or `#if` surrounds them.
/// Nothing if the submission does not have the task's line.
std::optional<std::string> with_one_task(const std::string& solution, const std::string& submitted,
                                         const std::string& task);

}  // namespace relief
