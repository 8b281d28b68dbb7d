// Ends work that nobody waits for any more.
#pragma once

#include <atomic>

namespace relief {

/// Thrown by parallel_each() after its caller's CancelledBy was set. Not an error.
struct Cancelled {};

/// While an object of this class lives, parallel_each() on this thread begins no further call once `flag` is set.
class CancelledBy {
public:
    /// Precondition: `flag` outlives this object, and the thread has no other object of this class.
    explicit CancelledBy(const std::atomic<bool>& flag);
    ~CancelledBy();
    CancelledBy(const CancelledBy&) = delete;
    CancelledBy& operator=(const CancelledBy&) = delete;
};

}  // namespace relief
