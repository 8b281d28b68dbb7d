// Work that is divided among threads.
#pragma once

#include <cstddef>
#include <functional>

namespace relief {

/// Returns the number of hardware threads, at least 1.
unsigned hardware_threads();

/// Cuts [0, count) into consecutive pieces, at most one per thread, and calls `work(begin, end)` for each. Each piece
/// but the last has at least `smallest` elements. The caller works on the first. Returns when all are done; rethrows
/// the exception of the first piece that failed. `threads` 0 means hardware_threads().
void parallel_pieces(size_t count, size_t smallest, unsigned threads,
                     const std::function<void(size_t begin, size_t end)>& work);

/// Calls `one(i)` for each i of [0, count) as threads become free: for work of unequal length. After a failure no
/// further call begins, and one of the exceptions is rethrown. `threads` 0 means hardware_threads().
void parallel_each(size_t count, unsigned threads, const std::function<void(size_t)>& one);

}  // namespace relief
