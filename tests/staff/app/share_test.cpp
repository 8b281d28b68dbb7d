// Work that is divided among processes.
#include "framework/staff/app/share.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <map>
#include <new>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"

namespace relief {
namespace {

TEST(SharedWork, GoesToAllProcessesOnceEach) {
    const unsigned wanted = std::min(40u, hardware_threads());
    void* const memory =
        mmap(nullptr, sizeof(std::atomic<unsigned>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    ASSERT_NE(memory, MAP_FAILED);
    auto* const with_a_part = new (memory) std::atomic<unsigned>(0);
    std::map<int, int> times;
    std::set<int> processes;
    share_among_processes(
        40,
        [&](const NextPart& next, const Say& say) {
            for (bool is_first = true; const auto part = next(); is_first = false) {
                if (is_first) ++*with_a_part;
                // On a busy machine, one process could take all parts before another one begins.
                for (int i = 0; i < 20'000 && *with_a_part < wanted; ++i) usleep(1000);
                say(fmt::format("{} {}", *part, getpid()));
            }
        },
        [&](const std::string& text) {
            const size_t space = text.find(' ');
            ++times[std::stoi(text.substr(0, space))];
            processes.insert(std::stoi(text.substr(space)));
        });
    EXPECT_EQ(times.size(), 40u);
    for (const auto& [part, count] : times) EXPECT_EQ(count, 1) << part;
    EXPECT_EQ(processes.size(), wanted);
    EXPECT_FALSE(processes.contains(getpid())) << "not in this one, which may have a context";
    munmap(memory, sizeof(std::atomic<unsigned>));
}

TEST(SharedWork, EndsWithAFailureOrCrash) {
    const auto failure = [](const std::function<void()>& fail) -> std::string {
        try {
            share_among_processes(
                1000,
                [&](const NextPart& next, const Say& say) {
                    while (const auto part = next()) {
                        if (*part == 3) fail();
                        say("x");
                    }
                },
                [](const std::string&) {});
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(failure([] { throw Error("the third is missing"); }), "the third is missing");
    EXPECT_TRUE(failure([] { raise(SIGKILL); }).starts_with("a process of this program crashed: "));
    EXPECT_EQ(failure([] { _exit(7); }), "a process of this program ended with exit code 7");
    EXPECT_EQ(failure([] {}), "");
}

}  // namespace
}  // namespace relief
