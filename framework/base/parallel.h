// Work that is shared among threads.
#pragma once

#include <cstddef>
#include <functional>

namespace relief {

/// As many threads as the machine has, at least 1.
unsigned hardware_threads();

/// Cuts [0, count) into one piece a thread, in order, each at least `smallest` long but perhaps the last, and calls
/// `work(begin, end)` for each; the caller works on the first. Returns when all are done, and throws what the first
/// piece that failed has thrown. `threads` 0 means hardware_threads().
void parallel_pieces(size_t count, size_t smallest, unsigned threads,
                     const std::function<void(size_t begin, size_t end)>& work);

/// Calls `one(i)` for each of [0, count), each when a thread is free for it: for work of unequal length. After a
/// failure none is begun, and what has failed first is thrown. `threads` 0 means hardware_threads().
void parallel_each(size_t count, unsigned threads, const std::function<void(size_t)>& one);

}  // namespace relief
