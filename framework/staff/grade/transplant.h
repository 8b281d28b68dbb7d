// One task of a submission in the course's own files, so that it is marked apart from mistakes in other tasks.
#pragma once

#include <optional>
#include <string>

namespace relief {

/// `solution`, the text of a task file, with the part of `submitted` that is about `task` ("11.2") in place of its own.
/// A task's part reaches from its line "// TASK 11.2" to the next such line. What stands before the first one is the
/// submission's: it may hold what all its tasks use. Nothing if the submission does not have the task's line.
std::optional<std::string> with_one_task(const std::string& solution, const std::string& submitted,
                                         const std::string& task);

}  // namespace relief
