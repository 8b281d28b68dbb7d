// Work in pieces: each part runs once, and failures are reported.
#include "framework/core/base/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <stdexcept>
#include <vector>

#include "framework/core/base/cancel.h"

namespace relief {
namespace {

TEST(Parallel, DoesEveryPartOnceForAnyNumberOfThreads) {
    for (const unsigned threads : {0u, 1u, 2u, 3u, 8u})
        for (const size_t count : {0u, 1u, 2u, 7u, 100u}) {
            std::vector<std::atomic<int>> done(count);
            parallel_pieces(count, 1, threads, [&](size_t begin, size_t end) {
                EXPECT_LT(begin, end);
                for (size_t i = begin; i < end; ++i) ++done.at(i);
            });
            for (size_t i = 0; i < count; ++i) EXPECT_EQ(done[i], 1) << i << " of " << count << ", " << threads;
        }
}

TEST(Parallel, DoesNotCutSmallWork) {
    std::mutex mutex;
    std::vector<std::pair<size_t, size_t>> pieces;
    parallel_pieces(100, 64, 8, [&](size_t begin, size_t end) {
        const std::lock_guard lock(mutex);
        pieces.emplace_back(begin, end);
    });
    EXPECT_EQ(pieces.size(), 2u);
}

TEST(Parallel, RethrowsAPiecesExceptionAfterTheOthersFinish) {
    std::atomic<size_t> done = 0;
    EXPECT_THROW(parallel_pieces(4, 1, 4,
                                 [&](size_t begin, size_t) {
                                     ++done;
                                     if (begin == 2) throw std::runtime_error("piece 2");
                                 }),
                 std::runtime_error);
    EXPECT_EQ(done, 4u);
}

TEST(Parallel, StartsNoItemAfterItsCallerWasCancelled) {
    std::atomic<bool> cancelled = false;
    std::atomic<size_t> begun = 0;
    const auto work = [&](size_t i) {
        ++begun;
        if (i == 2) cancelled = true;
    };
    {
        const CancelledBy cancel(cancelled);
        EXPECT_THROW(parallel_each(1000, 1, work), Cancelled);
        EXPECT_EQ(begun, 3u);
        EXPECT_THROW(parallel_each(1000, 4, work), Cancelled);
        EXPECT_EQ(begun, 3u) << "its helpers are cancelled, too";
    }
    parallel_each(1000, 4, work);
    EXPECT_EQ(begun, 1003u) << "nothing cancels this thread any more";
}

TEST(Parallel, RunsEachItemOnceForAnyNumberOfThreads) {
    for (const unsigned threads : {0u, 1u, 3u, 200u}) {
        std::vector<std::atomic<int>> done(100);
        parallel_each(done.size(), threads, [&](size_t i) { ++done[i]; });
        for (const auto& times : done) EXPECT_EQ(times, 1) << threads;
    }
}

TEST(Parallel, StartsNoItemAfterAFailure) {
    std::atomic<size_t> begun = 0;
    EXPECT_THROW(parallel_each(1000, 1,
                               [&](size_t i) {
                                   ++begun;
                                   if (i == 2) throw std::runtime_error("two");
                               }),
                 std::runtime_error);
    EXPECT_EQ(begun, 3u);
}

}  // namespace
}  // namespace relief
