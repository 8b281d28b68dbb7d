// Work that is shared among processes, for what one process can do once only at a time, such as drawing in a context.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace relief {

/// What a process is to do next, or nothing: each of [0, count) goes to one process.
using NextPart = std::function<std::optional<size_t>()>;
/// Sends a text to the process that waits for all.
using Say = std::function<void(const std::string& text)>;

/// Calls `work` in as many copies of this process as the machine has threads, but no more than `count`. What they say
/// comes to `hear`, one text at a time and those of one process in their order. Call it before any other thread is
/// begun. Returns when all have ended; throws Error with what the first that failed has thrown, or how it crashed, when
/// the others have done what they had begun.
void share_among_processes(size_t count, const std::function<void(const NextPart& next, const Say& say)>& work,
                           const std::function<void(const std::string& text)>& hear);

}  // namespace relief
