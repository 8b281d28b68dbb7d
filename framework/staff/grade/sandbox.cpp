#include "framework/staff/grade/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include "framework/base/descriptor.h"
#include "framework/check/drawing.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

constexpr size_t errors_kept = size_t{64} << 10;
/// More than this on standard error is a flood.
constexpr size_t errors_taken = size_t{16} << 20;
constexpr unsigned nobody = 65534;

struct Pipe {
    Descriptor read{-1}, write{-1};
    Pipe() {
        int ends[2];
        if (pipe2(ends, O_CLOEXEC) == 0) read = Descriptor(ends[0]), write = Descriptor(ends[1]);
    }
    bool good() const { return read >= 0; }
};

/// A file in memory that holds the input, so that nobody waits for a reader.
Descriptor input_file(const std::string& input) {
    Descriptor file(memfd_create("input", MFD_CLOEXEC));
    if (file >= 0 && (!write_all(file, input) || lseek(file, 0, SEEK_SET) != 0)) file.close();
    return file;
}

/// The descriptor on which bubblewrap tells that the command has begun, and how it ended.
constexpr int status_descriptor = 3;

Words bubblewrap(const SandboxJob& job) {
    Words words = {"/usr/bin/bwrap",
                   "--unshare-all",
                   "--unshare-user",
                   "--disable-userns",
                   "--die-with-parent",
                   "--new-session",
                   "--clearenv",
                   "--hostname",
                   "relief",
                   "--json-status-fd",
                   std::to_string(status_descriptor),
                   "--ro-bind",
                   "/usr",
                   "/usr"};
    // Where the system's top folders are links into /usr they stay links.
    std::error_code ignored;
    for (const char* folder : {"/bin", "/lib", "/lib32", "/lib64", "/sbin"})
        if (fs::is_symlink(folder, ignored))
            words.insert(words.end(), {"--symlink", fs::read_symlink(folder, ignored).string(), folder});
        else
            words.insert(words.end(), {"--ro-bind-try", folder, folder});
    // The linker's table, and the links to what a program is really called.
    for (const char* path : {"/etc/ld.so.cache", "/etc/alternatives"})
        words.insert(words.end(), {"--ro-bind-try", path, path});
    words.insert(words.end(), {"--dev", "/dev", "--size", std::to_string(job.limits.scratch), "--tmpfs", "/tmp"});
    for (const fs::path& path : job.readable) words.insert(words.end(), {"--ro-bind", path.string(), path.string()});
    words.insert(words.end(), {"--setenv", "PATH", "/usr/bin:/bin"});
    for (const auto& [name, value] : job.environment) words.insert(words.end(), {"--setenv", name, value});
    // Its own devices and mount points are in memory, too: nothing may be written there.
    words.insert(words.end(), {"--remount-ro", "/dev", "--remount-ro", "/", "--chdir", "/tmp"});
    // The number of processes counts inside the new user's namespace, so it is set there and not before.
    words.insert(words.end(), {"/usr/bin/prlimit", "--nproc=" + std::to_string(job.limits.processes), "--"});
    words.insert(words.end(), job.command.begin(), job.command.end());
    return words;
}

/// What the new process needs between fork and exec, where nothing may take memory: other threads may hold the lock.
struct Start {
    std::vector<const char*> words, environment;
    int in = -1, out = -1, err = -1, status = -1;
    rlim_t cpu = 0, memory = 0, file = 0;
    rlim_t processes = RLIM_INFINITY;
    bool drop = false;
};

void limit(int resource, rlim_t value, rlim_t more = 0) {
    const rlimit both{value, value + more};
    setrlimit(__rlimit_resource_t(resource), &both);
}

[[noreturn]] void start(const Start& s) {
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(s.in, 0), dup2(s.out, 1), dup2(s.err, 2);
    if (s.status >= 0) dup2(s.status, status_descriptor);
    // Whatever else is open here is none of its business.
    syscall(SYS_close_range, s.status >= 0 ? status_descriptor + 1 : 3, ~0U, 0);
    // When the machine has no memory left, it is this that goes, and no neighbour.
    if (const int score = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0) {
        [[maybe_unused]] const ssize_t written = write(score, "1000", 4);
        close(score);
    }
    limit(RLIMIT_CPU, s.cpu, 1);  // SIGXCPU, and SIGKILL for who does not listen
    limit(RLIMIT_AS, s.memory);
    limit(RLIMIT_FSIZE, s.file);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, 256);
    if (s.drop) {
        // The system calls themselves: the library's would try to tell other threads, which are not here.
        if (syscall(SYS_setgroups, 0, nullptr) != 0 || syscall(SYS_setresgid, nobody, nobody, nobody) != 0 ||
            syscall(SYS_setresuid, nobody, nobody, nobody) != 0)
            _exit(126);
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // a change of user takes it away
    }
    limit(RLIMIT_NPROC, s.processes);
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    execve(s.words[0], const_cast<char* const*>(s.words.data()), const_cast<char* const*>(s.environment.data()));
    _exit(127);
}

/// How many processes and threads a user has here.
rlim_t tasks_of(unsigned user) {
    rlim_t count = 0;
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator("/proc", ignored)) {
        struct stat status {};
        const std::string path = entry.path().string();
        if (!std::isdigit(static_cast<unsigned char>(path.back())) || stat(path.c_str(), &status) != 0) continue;
        if (status.st_uid != user) continue;
        for ([[maybe_unused]] const auto& task : fs::directory_iterator(path + "/task", ignored)) ++count;
    }
    return count;
}

/// Reads what there is. False at the end.
bool take_from(int descriptor, std::string& into, size_t most, size_t& taken) {
    char block[1 << 16];
    const ssize_t got = read(descriptor, block, sizeof block);
    if (got < 0 && errno == EINTR) return true;
    if (got <= 0) return false;
    taken += size_t(got);
    if (into.size() < most) into.append(block, std::min(size_t(got), most - into.size()));
    return true;
}

/// The number after "exit-code" in what bubblewrap says; nothing when the command never began.
bool find_exit_code(const std::string& status, int& code) {
    const size_t at = status.find("\"exit-code\":");
    if (at == std::string::npos) return false;
    code = std::atoi(status.c_str() + at + 12);
    return true;
}

/// A running command with its pipes.
class Running {
public:
    Running(const SandboxJob& job, Isolation isolation, bool drop) : job_(job), isolation_(isolation), drop_(drop) {}

    SandboxResult run() {
        if (!out_.good() || !err_.good() || !status_.good()) return failed("no pipe");
        if (!launch()) return failed("no new process");
        const auto begin = Clock::now();
        watch(begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(job_.limits.wall)));
        end_all();
        result_.wall = std::chrono::duration<double>(Clock::now() - begin).count();
        judge();
        return std::move(result_);
    }

private:
    SandboxResult failed(const char* what) {
        result_.errors = fmt::format("{}: {}", what, std::strerror(errno));
        return std::move(result_);
    }

    bool launch() {
        const Descriptor in = input_file(job_.input);
        if (in < 0) return false;
        const bool wrapped = isolation_ == Isolation::namespaces;
        const Words words = wrapped ? bubblewrap(job_) : job_.command;
        Words environment;
        if (!wrapped) {
            environment.push_back("PATH=/usr/bin:/bin");
            for (const auto& [name, value] : job_.environment) environment.push_back(name + "=" + value);
        }
        Start s;
        for (const std::string& word : words) s.words.push_back(word.c_str());
        for (const std::string& word : environment) s.environment.push_back(word.c_str());
        s.words.push_back(nullptr), s.environment.push_back(nullptr);
        s.in = in, s.out = out_.write, s.err = err_.write;
        if (wrapped) s.status = status_.write;
        s.cpu = rlim_t(job_.limits.cpu), s.memory = job_.limits.memory, s.file = job_.limits.scratch;
        s.drop = drop_;
        if (!wrapped) s.processes = tasks_of(s.drop ? nobody : getuid()) + rlim_t(job_.limits.processes);
        // dup2 must not hit an end that is still wanted.
        for (int* end : {&s.in, &s.out, &s.err, &s.status})
            if (*end >= 0) *end = fcntl(*end, F_DUPFD_CLOEXEC, 10), copies_.push_back(*end);
        process_ = fork();
        if (process_ == 0) start(s);
        for (const int copy : copies_) close(copy);
        out_.write.close(), err_.write.close(), status_.write.close();
        return process_ > 0;
    }

    /// Until both pipes are closed, or a bound is reached.
    void watch(Clock::time_point deadline) {
        size_t out_taken = 0, err_taken = 0, status_taken = 0;
        bool out_open = true, err_open = true, status_open = isolation_ == Isolation::namespaces;
        while (out_open || err_open || status_open) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
            if (left <= 0) return stop(Ending::out_of_time);
            pollfd ends[3] = {{out_open ? out_.read : -1, POLLIN, 0},
                              {err_open ? err_.read : -1, POLLIN, 0},
                              {status_open ? status_.read : -1, POLLIN, 0}};
            if (poll(ends, 3, int(std::min<int64_t>(left, 1000))) < 0 && errno != EINTR) return;
            if (ends[0].revents) out_open = take_from(out_.read, result_.output, job_.limits.output, out_taken);
            if (ends[1].revents) err_open = take_from(err_.read, result_.errors, errors_kept, err_taken);
            if (ends[2].revents) status_open = take_from(status_.read, status_text_, 1 << 12, status_taken);
            if (out_taken > job_.limits.output || err_taken > errors_taken) return stop(Ending::too_much_output);
            // Without namespaces a process that was left behind may hold the pipes: the command itself decides.
            if (isolation_ == Isolation::limits && has_ended()) {
                while (out_open && readable(out_.read) && out_taken <= job_.limits.output)
                    out_open = take_from(out_.read, result_.output, job_.limits.output, out_taken);
                return;
            }
        }
        while (!has_ended()) {
            if (Clock::now() >= deadline) return stop(Ending::out_of_time);
            usleep(1000);
        }
    }

    static bool readable(int descriptor) {
        pollfd end{descriptor, POLLIN, 0};
        return poll(&end, 1, 0) > 0 && (end.revents & POLLIN);
    }

    void stop(Ending ending) { stopped_ = true, result_.ending = ending; }

    bool has_ended() {
        if (!reaped_) reaped_ = waitpid(process_, &wait_status_, WNOHANG) == process_;
        return reaped_;
    }

    /// bubblewrap's end is the end of its namespace, and so of every process in it.
    void end_all() {
        kill(-process_, SIGKILL), kill(process_, SIGKILL);
        while (!reaped_ && waitpid(process_, &wait_status_, 0) < 0 && errno == EINTR) {
        }
    }

    void judge() {
        if (stopped_) return;
        int code = WIFEXITED(wait_status_) ? WEXITSTATUS(wait_status_) : 128 + WTERMSIG(wait_status_);
        if (isolation_ == Isolation::namespaces && !find_exit_code(status_text_, code)) {
            result_.ending = Ending::failed;
            if (result_.errors.empty()) result_.errors = fmt::format("bubblewrap ended with {}", code);
            return;
        }
        result_.code = code, result_.ending = Ending::exited;
        if (code == out_of_memory_code) result_.ending = Ending::out_of_memory;
        if (code <= 128) return;
        result_.code = code - 128;
        // We have not sent it: the system does when memory runs out.
        result_.ending = result_.code == SIGKILL   ? Ending::out_of_memory
                         : result_.code == SIGXCPU ? Ending::out_of_time
                                                   : Ending::crashed;
    }

    const SandboxJob& job_;
    Isolation isolation_;
    bool drop_;  ///< from root to nobody
    Pipe out_, err_, status_;
    std::vector<int> copies_;
    pid_t process_ = -1;
    int wait_status_ = 0;
    bool reaped_ = false, stopped_ = false;
    std::string status_text_;
    SandboxResult result_;
};

}  // namespace

const char* name_of(Isolation isolation) { return isolation == Isolation::namespaces ? "namespaces" : "limits"; }

const char* name_of(Ending ending) {
    constexpr const char* names[] = {"exited", "crashed", "out of time", "out of memory", "too much output", "failed"};
    return names[int(ending)];
}

IsolationReport probe_isolation() {
    std::error_code ignored;
    if (std::getenv("RELIEF_NO_NAMESPACES")) return {Isolation::limits, "RELIEF_NO_NAMESPACES is set"};
    if (!fs::exists("/usr/bin/bwrap", ignored))
        return {Isolation::limits, "there is no /usr/bin/bwrap: install the Debian package bubblewrap"};
    const SandboxResult tried = run_sandboxed(
        {.command = {"/usr/bin/true"}, .readable = {}, .environment = {}, .input = {}, .limits = {.wall = 10}},
        Isolation::namespaces);
    if (tried.ending == Ending::exited && tried.code == 0) return {Isolation::namespaces, ""};
    const std::string reason = tried.errors.substr(0, tried.errors.find('\n'));
    return {Isolation::limits, "this system does not let bubblewrap make namespaces (" + reason + ")"};
}

SandboxResult run_sandboxed(const SandboxJob& job, Isolation isolation) {
    return Running(job, isolation, geteuid() == 0).run();
}

SandboxResult run_trusted(const SandboxJob& job) { return Running(job, Isolation::limits, false).run(); }

}  // namespace relief
