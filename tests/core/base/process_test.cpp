// Programs that are started with limits, and functions whose crash does not end this process. The sandbox's tests cover
// more of the limits.
#include "framework/core/base/process.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdlib>

#include "framework/core/base/error.h"
#include "framework/core/base/parallel.h"
#include "tests/support.h"

namespace relief {
namespace {

ProcessResult run_shell(const std::string& script, ProcessLimits limits = {.wall = 10}) {
    return run_process({.command = {"/bin/sh", "-c", script}, .input = "the input", .limits = limits});
}

TEST(Processes, GiveOutputErrorsAndTheExitCode) {
    const ProcessResult done = run_shell("cat; echo oh >&2; exit 3");
    EXPECT_EQ(done.ending, Ending::exited);
    EXPECT_EQ(done.code, 3);
    EXPECT_EQ(done.output, "the input");
    EXPECT_EQ(done.errors, "oh\n");
}

TEST(Processes, EndAtTheirLimits) {
    EXPECT_EQ(run_shell("sleep 60", {.wall = 0.2}).ending, Ending::out_of_time);
    EXPECT_EQ(run_shell("exec >&- 2>&-; sleep 60", {.wall = 0.2}).ending, Ending::out_of_time);
    EXPECT_EQ(run_shell("yes", {.wall = 10, .output = 1 << 20}).ending, Ending::too_much_output);
    EXPECT_EQ(run_shell("kill -SEGV $$").ending, Ending::crashed);
}

TEST(Processes, EndWithTheirProgramEvenIfAChildHoldsTheirOutput) {
    const ProcessResult done = run_shell("sleep 60 & echo started");
    EXPECT_EQ(done.output, "started\n");
    EXPECT_TRUE(done.succeeded()) << name_of(done.ending);
}

TEST(Processes, ReportBesideTheirOutput) {
    const ProcessResult done = run_process(
        {.command = {"/bin/sh", "-c", "echo seen; echo told >&3"}, .limits = {.wall = 10}, .reports = true});
    EXPECT_EQ(done.output, "seen\n");
    EXPECT_EQ(done.report, "told\n");
}

TEST(Processes, SayWhyAProgramCannotBeStarted) {
    const ProcessResult none = run_process({.command = {"/nowhere/at/all"}, .limits = {.wall = 10}});
    EXPECT_EQ(none.ending, Ending::failed);
    EXPECT_EQ(none.errors, "cannot start /nowhere/at/all: No such file or directory");
}

// The system counts a user's processes on the whole machine, including other containers. So a limit could fail an
// honest command because of other processes.
TEST(Processes, DoNotLimitTheUsersProcessCount) {
    std::ifstream file("/proc/self/limits");
    std::string line;
    while (std::getline(file, line) && !line.starts_with("Max processes")) {
    }
    ASSERT_FALSE(line.empty());
    EXPECT_EQ(run_shell("grep '^Max processes' /proc/self/limits").output, line + "\n");
}

TEST(Processes, ReadTheirNote) {
    const std::string descriptor = std::to_string(note_descriptor);
    EXPECT_EQ(run_process({.command = {"/bin/sh", "-c", "cat <&" + descriptor}, .note = "a note"}).output, "a note");
    EXPECT_NE(run_process({.command = {"/bin/sh", "-c", "cat <&" + descriptor}}).code, 0) << "there is none";
}

TEST(Processes, AChildsCrashIsNotOurs) {
    EXPECT_EQ(ChildProcess([] { std::signal(SIGSEGV, SIG_DFL), std::raise(SIGSEGV); }).wait().crash,
              "Segmentation fault");
    const ChildEnd ended = ChildProcess([] { std::_Exit(7); }).wait();
    EXPECT_EQ(ended.code, 7);
    EXPECT_EQ(ended.crash, "");
    EXPECT_EQ(ChildProcess([] { throw std::runtime_error("not ours"); }).wait().code, 1);
    EXPECT_EQ(ChildProcess([] {}).wait().code, 0);
}

TEST(Processes, AChildEndsWithItsOwner) {
    Pipe pipe;
    {
        const ChildProcess endless([&] {
            pipe.read.close();
            for (;;) write_all(pipe.write, "x");
        });
        pipe.write.close();
        char first = 0;
        EXPECT_TRUE(read_all(pipe.read, &first, 1));
    }
    std::string rest(1 << 20, ' ');  // more than a pipe holds: only the child's end can end this
    EXPECT_FALSE(read_all(pipe.read, rest.data(), rest.size()));
}

}  // namespace
}  // namespace relief
