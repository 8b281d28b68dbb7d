// Work that is divided among processes, for tasks that one process can do only one at a time, such as drawing in a
// context.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace relief {

/// Returns the next part for a process, or nothing when no part is left. Each of [0, count) goes to one process.
using NextPart = std::function<std::optional<size_t>()>;
/// Sends a text to the process that waits for all others.
using Say = std::function<void(const std::string& text)>;

/// Calls `work` in copies of this process: one per hardware thread, but at most `count`. `hear` receives their texts
/// one at a time, and the texts of one process in order. Precondition: this process has started no other thread.
/// Returns when all copies have ended. After a failure, the others finish the parts that they have begun. Then throws
/// Error with the first failure's message or crash. Where the system cannot copy a process, `work` runs once, in this
/// one.
void share_among_processes(size_t count, const std::function<void(const NextPart& next, const Say& say)>& work,
                           const std::function<void(const std::string& text)>& hear);

}  // namespace relief
