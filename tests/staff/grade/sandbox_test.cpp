// The limits of a command in the sandbox, and how each kind of failure is distinguished. On a machine without
// namespaces the tests use resource limits only, say so, and skip the guarantees that need namespaces.
#include "framework/staff/grade/sandbox.h"

#include <csignal>
#include <fstream>
#include <thread>

#include "framework/staff/grade/control_group.h"
#include "tests/support.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

class Sandbox : public testing::Test {
protected:
    static void SetUpTestSuite() {
        isolation_ = probe_isolation();
        std::printf("isolation: %s %s\n", name_of(isolation_.level), isolation_.reason.c_str());
    }
    static ProcessResult shell(const std::string& script, ProcessLimits limits = {.wall = 10},
                               std::vector<fs::path> readable = {}, int processes = 64) {
        return run_sandboxed({.command = {"/bin/sh", "-c", script},
                              .environment = {{"A", "b c"}},
                              .input = "the input",
                              .limits = limits},
                             {isolation_.level, std::move(readable), processes});
    }
    static bool has_namespaces() { return isolation_.level != Isolation::limits; }
    static bool has_groups() { return isolation_.level == Isolation::groups; }
    static inline IsolationReport isolation_;
};

TEST_F(Sandbox, PassesOnInputOutputErrorsAndTheExitCode) {
    const ProcessResult done = shell("cat; echo \"$A\"; echo oh >&2; exit 3");
    EXPECT_EQ(done.ending, Ending::exited) << done.errors;
    EXPECT_EQ(done.code, 3);
    EXPECT_EQ(done.output, "the inputb c\n");
    EXPECT_EQ(done.errors, "oh\n");
}

TEST(Namespaces, ARefusalNamesItsCauseAndTheRemedy) {
    const TemporaryFolder folder;
    const IsolationReport unknown = refused_namespaces("bwrap: no", folder.path());
    EXPECT_EQ(unknown.level, Isolation::limits);
    EXPECT_EQ(unknown.reason, "this system does not let bubblewrap make namespaces (bwrap: no)");
    EXPECT_EQ(unknown.remedy, "");

    const std::string setting = "proc/sys/kernel/apparmor_restrict_unprivileged_userns";
    folder.write(setting, "0\n");
    EXPECT_EQ(refused_namespaces("bwrap: no", folder.path()).remedy, "") << "AppArmor is not the cause";
    folder.write(setting, "1\n");
    const IsolationReport ubuntu = refused_namespaces("bwrap: no", folder.path());
    EXPECT_TRUE(ubuntu.reason.ends_with(": AppArmor forbids them")) << ubuntu.reason;
    EXPECT_TRUE(contains(ubuntu.remedy, "profile relief-bwrap /usr/bin/bwrap flags=(unconfined) {\n  userns,\n}\n"))
        << ubuntu.remedy;
    EXPECT_FALSE(contains(ubuntu.remedy, "container"));

    folder.write(".dockerenv", "");
    const IsolationReport nested = refused_namespaces("bwrap: no", folder.path());
    EXPECT_TRUE(contains(nested.remedy, "--security-opt seccomp=unconfined --security-opt apparmor=unconfined"));
    EXPECT_TRUE(contains(nested.remedy, "on the host save")) << nested.remedy;
    folder.write(setting, "0\n");
    EXPECT_FALSE(contains(refused_namespaces("bwrap: no", folder.path()).remedy, "profile"));
}

TEST_F(Sandbox, HasAClearedEnvironment) {
    setenv("RELIEF_SECRET", "x", 1);
    const ProcessResult done = shell("env | cut -d= -f1 | sort | tr '\\n' ' '");
    unsetenv("RELIEF_SECRET");
    EXPECT_EQ(done.output, "A PATH PWD ");
}

TEST_F(Sandbox, DistinguishesHowAProgramEnds) {
    EXPECT_EQ(shell("sleep 60", {.wall = 0.3}).ending, Ending::out_of_time);
    EXPECT_EQ(shell("while :; do :; done", {.wall = 10, .cpu = 1}).ending, Ending::out_of_time);
    const ProcessResult crashed = shell("kill -SEGV $$");
    EXPECT_EQ(crashed.ending, Ending::crashed);
    EXPECT_EQ(crashed.code, SIGSEGV);
    EXPECT_EQ(shell("trap '' XCPU; while :; do :; done", {.wall = 20, .cpu = 1}).ending, Ending::out_of_time)
        << "the system kills a program that ignores the signal";
    EXPECT_EQ(shell("kill -KILL $$").ending, Ending::crashed) << "its time was not over";
    EXPECT_EQ(shell("yes", {.wall = 10, .output = 1 << 20}).ending, Ending::too_much_output);
    EXPECT_EQ(shell("yes >&2", {.wall = 10}).ending, Ending::too_much_output);
    const ProcessResult flood = shell("yes", {.wall = 10, .output = 1 << 20});
    EXPECT_EQ(flood.output.size(), size_t{1} << 20);
}

TEST_F(Sandbox, BoundsMemoryFilesAndProcesses) {
    // dd allocates its block in memory.
    EXPECT_NE(shell("dd if=/dev/zero of=/dev/null bs=1G count=1", {.wall = 10, .memory = 256 << 20}).code, 0);
    EXPECT_EQ(shell("dd if=/dev/zero of=/dev/null bs=64M count=1 2>/dev/null", {.wall = 10, .memory = 256 << 20}).code,
              0);
    const ProcessResult full = shell("f=$(mktemp) && dd if=/dev/zero of=$f bs=1M count=100; wc -c < $f; rm -f $f",
                                     {.wall = 10, .file = 8 << 20});
    EXPECT_LE(std::atol(full.output.c_str()), 8 << 20) << full.errors;
    if (!has_namespaces()) return;
    const ProcessResult bomb = shell("b() { b | b & }; b; sleep 0.5; echo alive", {.wall = 5}, {}, 30);
    EXPECT_TRUE(contains(bomb.errors, "fork")) << bomb.errors;
}

// tests/control_groups.sh runs these tests on a machine that has control groups.
TEST_F(Sandbox, AControlGroupLimitsAllProcessesTogether) {
    if (!has_groups()) {
        std::printf("not looked at without control groups: processes together can take more than one of them may\n");
        return;
    }
    const auto python = [](Isolation level, const std::string& script, size_t memory) {
        return run_sandboxed({.command = {"/usr/bin/python3", "-c", "import os, time\n" + script},
                              .limits = {.wall = 60, .cpu = 60, .memory = memory, .file = size_t{256} << 20}},
                             {.isolation = level});
    };
    constexpr size_t mebi = size_t{1} << 20;
    const std::string four =
        "for i in range(3): os.fork() or (bytearray(b'1') * (90 << 20), time.sleep(2), os._exit(0))\n"
        "x = bytearray(b'1') * (90 << 20); time.sleep(2); print('all')";
    const std::string file =
        "with open('/tmp/x', 'wb') as f:\n  for i in range(200): f.write(bytes(1 << 20))\nprint('all')";
    const std::string files = "for i in range(100000): os.close(os.open('/tmp/%d' % i, os.O_CREAT))\nprint('all')";
    for (const std::string& script : {four, file, files}) {
        SCOPED_TRACE(script);
        const size_t memory = script == files ? 64 * mebi : 160 * mebi;
        // Each single process and file is within the limits.
        EXPECT_EQ(python(Isolation::namespaces, script, memory).output, "all\n");
        const ProcessResult stopped = python(Isolation::groups, script, memory);
        EXPECT_EQ(stopped.ending, Ending::out_of_memory) << name_of(stopped.ending) << stopped.errors;
        EXPECT_EQ(stopped.output, "");
        EXPECT_EQ(python(Isolation::groups, script, 1024 * mebi).output, "all\n");
    }
    // The sandbox's namespace also limits the number of processes, so this part runs without it.
    const std::string many =
        "n=0\nfor i in range(40):\n  try: os.fork() or os.execlp('sleep', 'sleep', '2')\n"
        "  except OSError: break\n  n += 1\nprint(n)";
    const auto started = [&](const fs::path& group) {
        return run_process(
            {.command = {"/usr/bin/python3", "-c", "import os\n" + many}, .limits = {.wall = 20}, .group = group});
    };
    const ControlGroup group(256 * mebi, 20);
    EXPECT_EQ(started(group.folder()).output, "19\n");
    EXPECT_EQ(started({}).output, "40\n");
}

// Otherwise the grader would fill the system with groups.
TEST_F(Sandbox, LeavesNoControlGroupBehind) {
    if (!has_groups()) {
        std::printf("not looked at without control groups\n");
        return;
    }
    fs::path folder;
    {
        const ControlGroup group(size_t{64} << 20, 4);
        folder = group.folder();
        EXPECT_TRUE(fs::exists(folder));
        EXPECT_FALSE(group.ran_out_of_memory());
    }
    EXPECT_FALSE(fs::exists(folder));
    shell("setsid sleep 60 & echo started");
    for (const auto& entry : fs::directory_iterator(folder.parent_path()))
        EXPECT_FALSE(entry.path().filename().string().starts_with("relief-" + std::to_string(getpid())))
            << entry.path();
}

// Tests every isolation level.
TEST_F(Sandbox, BlocksSystemCallsThatNoSubmissionNeeds) {
    const auto python = [](Isolation level, const std::string& script, bool makes_processes) {
        const std::string prelude = R"(
import ctypes, mmap, os, socket, threading
c = ctypes.CDLL(None, use_errno=True)
def told(name, result): print(name, 'done' if result >= 0 else os.strerror(ctypes.get_errno()))
def tried(name, what):
    try: what(); print(name, 'done')
    except OSError as error: print(name, error.strerror)
)";
        const ProcessResult done =
            run_sandboxed({.command = {"/usr/bin/python3", "-c", prelude + script}, .limits = {.wall = 20}},
                          {.isolation = level, .makes_processes = makes_processes});
        return done.errors.empty() ? done.output : done.output + done.errors;
    };
    std::vector<Isolation> levels = {Isolation::limits};
    if (has_namespaces()) levels.push_back(Isolation::namespaces);
    if (has_groups()) levels.push_back(Isolation::groups);
    for (const Isolation level : levels) {
        SCOPED_TRACE(name_of(level));
        for (const bool makes_processes : {false, true})
            EXPECT_EQ(python(level, R"(
tried('memory', lambda: os.memfd_create('x'))
told('shared', c.shmget(0, 1 << 20, 0o1600))
told('trace', c.ptrace(0, 0, 0, 0))
tried('socket', lambda: socket.socket(socket.AF_UNIX))
told('space', c.unshare(0x10000000))
clone = {'x86_64': 56, 'aarch64': 220}[os.uname().machine]
told('child in a space', c.syscall(clone, 0x10000011, 0, 0, 0, 0))
t = threading.Thread(target=lambda: print('thread done')); t.start(); t.join()
)",
                             makes_processes),
                      "memory Function not implemented\nshared Operation not permitted\n"
                      "trace Operation not permitted\nsocket Operation not permitted\n"
                      "space Operation not permitted\nchild in a space Operation not permitted\nthread done\n");
        const std::string fork = "tried('fork', lambda: os.fork() or os._exit(0))";
        EXPECT_EQ(python(level, fork, true), "fork done\n");
        EXPECT_EQ(python(level, fork, false), "fork Operation not permitted\n");
        EXPECT_EQ(python(level, "tried('note', lambda: os.fstat(" + std::to_string(note_descriptor) + "))", false),
                  "note Bad file descriptor\n");
    }
}

TEST_F(Sandbox, ACommandThatCannotStartIsNotReportedAsACrash) {
    const ProcessResult none =
        run_sandboxed({.command = {"/nowhere/at/all"}, .limits = {.wall = 10}}, {.isolation = isolation_.level});
    EXPECT_NE(none.ending, Ending::crashed);
    EXPECT_FALSE(none.succeeded());
}

TEST_F(Sandbox, ARequestIsSentOnlyWhenAskedFor) {
    const std::string request(300000, 'r');  // more than a pipe holds
    const auto ask = [&](const std::string& script) {
        return run_sandboxed({.command = {"/usr/bin/python3", "-c", "import os, select, sys\n" + script},
                              .request = request,
                              .asks = "please",
                              .limits = {.wall = 10}},
                             {.isolation = isolation_.level});
    };
    const std::string number = std::to_string(request_descriptor);
    const ProcessResult early = ask("print(select.select([" + number + "], [], [], 0.3)[0], os.read(0, 9))");
    EXPECT_EQ(early.output, "[] b''\n") << early.errors;
    const ProcessResult asked =
        ask("print('please', flush=True)\nwith os.fdopen(" + number + ") as f: print(len(f.read()))");
    EXPECT_EQ(asked.output, "please\n300000\n") << asked.errors;
    EXPECT_EQ(ask("print('please', flush=True); os.close(" + number + ")").ending, Ending::exited);
}

TEST_F(Sandbox, LeavesNoProcessBehind) {
    if (!has_namespaces()) {
        std::printf("not looked at without namespaces: a process in a session of its own stays\n");
        return;
    }
    const TemporaryFolder folder;
    const std::string mark = "31.4159" + std::to_string(getpid());  // identifies the process
    const ProcessResult done = shell("setsid sleep " + mark + " >/dev/null 2>&1 & echo started");
    EXPECT_EQ(done.output, "started\n");
    const auto left = [&] {
        for (const auto& entry : fs::directory_iterator("/proc")) {
            std::ifstream words(entry.path() / "cmdline");
            if (contains(std::string(std::istreambuf_iterator<char>(words), {}), mark)) return true;
        }
        return false;
    };
    // The kernel kills them after the first process of their namespace, with a short delay on a busy machine.
    for (int i = 0; i < 500 && left(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_FALSE(left());
}

TEST_F(Sandbox, HidesTheMachine) {
    const TemporaryFolder folder;
    const fs::path secret = folder.write("secret", "the answer");
    const fs::path open = folder.write("open/file", "yours");
    const auto look = [&](const std::string& script) {
        return shell(script, {.wall = 10}, {folder.path() / "open"}).output;
    };
    EXPECT_EQ(look("cat " + open.string()), "yours");
    if (!has_namespaces()) {
        std::printf("not looked at without namespaces: the command can read what we can\n");
        return;
    }
    EXPECT_EQ(look("cat " + secret.string() + " /etc/passwd /proc/1/environ"), "");
    EXPECT_EQ(look("ls / | tr '\\n' ' ' | sed 's/lib32 //; s/libx32 //'"), "bin dev etc lib lib64 sbin tmp usr ");
    // Nothing is writable except its own /tmp, which is removed afterwards.
    EXPECT_EQ(look("for f in /x /usr/x /dev/shm/x /etc/x " + open.string() + "; do echo x > $f && echo wrote $f; done"),
              "");
    EXPECT_EQ(look("echo x > /tmp/x && cat /tmp/x"), "x\n");
    EXPECT_EQ(look("cat /tmp/x"), "");
    const std::string user = std::to_string(geteuid() == 0 ? 65534 : geteuid());
    EXPECT_EQ(look("id -u; cat /sys/class/net/*/address; hostname"), user + "\nrelief\n");
    // The command is not root inside either, and cannot create a nested namespace.
    EXPECT_EQ(look("unshare -r true && echo made"), "");
}

}  // namespace
}  // namespace relief::grade
