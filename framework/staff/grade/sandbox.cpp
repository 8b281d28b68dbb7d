#include "framework/staff/grade/sandbox.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/sched.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
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

/// What is sent through it needs no reader to be sent, and ends nobody where the reader has gone.
struct Wire {
    Descriptor ours{-1}, theirs{-1};
    Wire() {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) == 0)
            ours = Descriptor(ends[0]), theirs = Descriptor(ends[1]);
    }
};

/// A file in memory that holds the input, so that nobody waits for a reader.
Descriptor input_file(const std::string& input) {
    Descriptor file(memfd_create("input", MFD_CLOEXEC));
    if (file >= 0 && (!write_all(file, input) || lseek(file, 0, SEEK_SET) != 0)) file.close();
    return file;
}

/// The descriptor on which bubblewrap tells that the command has begun, and how it ended; without it, on which we are
/// told why it has not begun.
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
    int in = -1, out = -1, err = -1, status = -1, request = -1;
    rlim_t cpu = 0, memory = 0, file = 0;
    bool wrapped = false, drop = false, makes_processes = true;
};

void limit(int resource, rlim_t value, rlim_t more = 0) {
    const rlimit both{value, value + more};
    setrlimit(__rlimit_resource_t(resource), &both);
}

/// From here on a new thread is all that can be made. A limit on processes would count those of the user that others
/// have started, wherever they run on this machine: then an honest program fails for its neighbour's sake.
bool refuse_processes() {
#if defined __x86_64__ || defined __aarch64__
    #if defined __x86_64__
    constexpr unsigned own = AUDIT_ARCH_X86_64;
    #else
    constexpr unsigned own = AUDIT_ARCH_AARCH64;
    #endif
    constexpr unsigned other_numbers = 0x40000000;  // the same machine's calls of another kind
    constexpr unsigned not_here = SECCOMP_RET_ERRNO | ENOSYS, refused = SECCOMP_RET_ERRNO | EPERM;
    const auto read = [](size_t offset) { return sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, unsigned(offset)); };
    const auto give = [](unsigned what) { return sock_filter BPF_STMT(BPF_RET | BPF_K, what); };
    const auto skip_unless = [](unsigned value) {
        return sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1);
    };
    sock_filter steps[] = {
        read(offsetof(seccomp_data, arch)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, own, 1, 0),
        give(not_here),
        read(offsetof(seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, other_numbers, 0, 1),
        give(not_here),
        // Its flags are out of sight: the library then takes clone.
        skip_unless(SYS_clone3),
        give(not_here),
    #if defined __x86_64__
        skip_unless(SYS_fork),
        give(refused),
        skip_unless(SYS_vfork),
        give(refused),
    #endif
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_clone, 0, 3),
        read(offsetof(seccomp_data, args)),
        BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, CLONE_THREAD, 1, 0),
        give(refused),
        give(SECCOMP_RET_ALLOW),
    };
    sock_fprog program{std::size(steps), steps};
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
#else
    return true;
#endif
}

/// It has not begun: says why, where the parent can be told.
[[noreturn]] void give_up(const Start& s) {
    const int reason = errno;
    if (!s.wrapped) {
        [[maybe_unused]] const ssize_t written = write(status_descriptor, &reason, sizeof reason);
    }
    _exit(126);
}

[[noreturn]] void start(const Start& s) {
    setsid();
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(s.in, 0), dup2(s.out, 1), dup2(s.err, 2);
    dup2(s.status, status_descriptor);
    if (!s.wrapped) fcntl(status_descriptor, F_SETFD, FD_CLOEXEC);  // open until it has begun
    if (s.request >= 0) dup2(s.request, request_descriptor);
    // Whatever else is open here is none of its business.
    syscall(SYS_close_range, status_descriptor + 1, request_descriptor - 1, 0);
    syscall(SYS_close_range, request_descriptor + (s.request >= 0 ? 1 : 0), ~0U, 0);
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
            give_up(s);
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // a change of user takes it away
    }
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    if (!s.wrapped && !s.makes_processes && !refuse_processes()) give_up(s);
    execve(s.words[0], const_cast<char* const*>(s.words.data()), const_cast<char* const*>(s.environment.data()));
    give_up(s);
}

/// Reads what there is. False at the end.
bool take_from(int descriptor, std::string& into, size_t max_size, size_t& taken) {
    char block[1 << 16];
    const ssize_t got = read(descriptor, block, sizeof block);
    if (got < 0 && errno == EINTR) return true;
    if (got <= 0) return false;
    taken += size_t(got);
    if (into.size() < max_size) into.append(block, std::min(size_t(got), max_size - into.size()));
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
        if (!out_.good() || !err_.good() || !status_.good() || wire_.ours < 0) return failed("no pipe");
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
        s.status = status_.write, s.wrapped = wrapped;
        if (!job_.request.empty()) s.request = wire_.theirs;
        s.makes_processes = job_.makes_processes;
        s.cpu = rlim_t(job_.limits.cpu), s.memory = job_.limits.memory, s.file = job_.limits.scratch;
        s.drop = drop_;
        // dup2 must not hit an end that is still wanted.
        std::vector<Descriptor> copies;
        for (int* end : {&s.in, &s.out, &s.err, &s.status, &s.request}) {
            if (*end < 0) continue;
            *end = copies.emplace_back(fcntl(*end, F_DUPFD_CLOEXEC, request_descriptor + 1));
            if (*end < 0) return false;
        }
        process_ = fork();
        if (process_ == 0) start(s);
        out_.write.close(), err_.write.close(), status_.write.close(), wire_.theirs.close();
        return process_ > 0;
    }

    /// Until both pipes are closed, or a bound is reached.
    void watch(Clock::time_point deadline) {
        size_t out_taken = 0, err_taken = 0, status_taken = 0;
        bool out_open = true, err_open = true, status_open = true;
        while (out_open || err_open || status_open) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
            if (left <= 0) return stop(Ending::out_of_time);
            const bool sends = wire_.ours >= 0 && !job_.request.empty() && result_.output.starts_with(job_.asks);
            pollfd ends[4] = {{out_open ? out_.read : -1, POLLIN, 0},
                              {err_open ? err_.read : -1, POLLIN, 0},
                              {status_open ? status_.read : -1, POLLIN, 0},
                              {sends ? wire_.ours : -1, POLLOUT, 0}};
            if (poll(ends, 4, int(std::min<int64_t>(left, 1000))) < 0 && errno != EINTR) return;
            if (ends[3].revents) send_request();
            if (ends[0].revents) out_open = take_from(out_.read, result_.output, job_.limits.output, out_taken);
            if (ends[1].revents) err_open = take_from(err_.read, result_.errors, errors_kept, err_taken);
            if (ends[2].revents) status_open = take_from(status_.read, status_text_, 1 << 12, status_taken);
            if (out_taken > job_.limits.output || err_taken > errors_taken) return stop(Ending::too_much_output);
            // Without namespaces a process that was left behind may hold the pipes: the command itself decides.
            if (isolation_ == Isolation::limits && has_ended()) {
                while (out_open && readable(out_.read) && out_taken <= job_.limits.output)
                    out_open = take_from(out_.read, result_.output, job_.limits.output, out_taken);
                if (status_open && readable(status_.read))
                    take_from(status_.read, status_text_, sizeof(int), status_taken);
                return;
            }
        }
        while (!has_ended()) {
            if (Clock::now() >= deadline) return stop(Ending::out_of_time);
            usleep(1000);
        }
    }

    /// As much as goes; what was sent whole is ended.
    void send_request() {
        const std::string_view rest = std::string_view(job_.request).substr(sent_);
        const ssize_t sent = send(wire_.ours, rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent > 0) sent_ += size_t(sent);
        const bool later = sent < 0 && (errno == EAGAIN || errno == EINTR);
        if (sent_ == job_.request.size() || (sent < 0 && !later)) wire_.ours.close();
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
        if (int reason = 0; isolation_ == Isolation::limits && status_text_.size() == sizeof reason) {
            std::memcpy(&reason, status_text_.data(), sizeof reason);
            result_.ending = Ending::failed;
            result_.errors = fmt::format("cannot start {}: {}", job_.command.front(), std::strerror(reason));
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
    Wire wire_;
    size_t sent_ = 0;  ///< of the request
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
