#include "framework/core/base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <functional>
#include <system_error>
#include <thread>
#include <vector>

#include "framework/core/base/cancel.h"

namespace relief {
namespace {

thread_local const std::atomic<bool>* cancelling = nullptr;

/// Threads that are joined at the end, as std::jthread, which not every standard library has.
class Helpers {
public:
    explicit Helpers(size_t most) { threads_.reserve(most); }
    ~Helpers() {
        for (std::thread& each : threads_) each.join();
    }
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;

    template <class Work>
    void start(const Work& work, size_t piece) {
        threads_.emplace_back(std::cref(work), piece);
    }

private:
    std::vector<std::thread> threads_;
};

}  // namespace

CancelledBy::CancelledBy(const std::atomic<bool>& flag) { cancelling = &flag; }
CancelledBy::~CancelledBy() { cancelling = nullptr; }

unsigned hardware_threads() { return std::max(1u, std::thread::hardware_concurrency()); }

void parallel_pieces(size_t count, size_t smallest, unsigned threads,
                     const std::function<void(size_t begin, size_t end)>& work) {
    if (count == 0) return;
    if (threads == 0) threads = hardware_threads();
    const size_t length = std::max({size_t{1}, smallest, (count - 1) / threads + 1}), pieces = (count - 1) / length + 1;
    std::vector<std::exception_ptr> failures(pieces);
    const auto run = [&](size_t piece) noexcept {
        try {
            work(piece * length, std::min(count, (piece + 1) * length));
        } catch (...) {
            failures[piece] = std::current_exception();
        }
    };
    {
        Helpers helpers(pieces - 1);
        for (size_t piece = 1; piece < pieces; ++piece) {
            try {
                helpers.start(run, piece);
            } catch (const std::system_error&) {
                run(piece);  // the system has no more threads: use this one
            }
        }
        run(0);
    }
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

void parallel_each(size_t count, unsigned threads, const std::function<void(size_t)>& one) {
    if (threads == 0) threads = hardware_threads();
    std::atomic<size_t> next = 0;
    const std::atomic<bool>* const cancelled = cancelling;  // the caller's, for all threads
    // One piece per thread; each takes the next index until none is left.
    parallel_pieces(std::min(count, size_t{threads}), 1, threads, [&](size_t, size_t) {
        try {
            for (size_t i = next++; i < count; i = next++) {
                if (cancelled && *cancelled) throw Cancelled();
                one(i);
            }
        } catch (...) {
            next = count;
            throw;
        }
    });
}

}  // namespace relief
