// Implements framework/core/base/process.h for Linux.
#include "framework/core/base/process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "framework/core/base/error.h"
#include "framework/core/base/system.h"

namespace relief {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr size_t output_block = size_t{64} << 10;
/// More bytes than this on standard error count as too much output.
constexpr size_t max_errors = size_t{16} << 20;
constexpr unsigned nobody = 65534;
/// The descriptor on which a new process reports why its program cannot start.
constexpr int told_descriptor = note_descriptor + 1;

/// A pair of sockets. Unlike with a pipe, a write need not wait for a reader, and raises no signal when the reader has
/// gone.
struct Wire {
    Descriptor ours{-1}, theirs{-1};
    Wire() {
        int ends[2];
        if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
            throw Error(fmt::format("no pipe: {}", std::strerror(errno)));
        ours = Descriptor(ends[0]), theirs = Descriptor(ends[1]);
    }
};

/// Returns a file in memory that holds a text. Unlike a pipe, it never blocks the writer.
Descriptor file_in_memory(const std::string& text) {
    Descriptor file(memfd_create("text", MFD_CLOEXEC));
    if (file < 0 || !write_all(file, text) || lseek(file, 0, SEEK_SET) != 0)
        throw Error(fmt::format("no memory for what a program reads: {}", std::strerror(errno)));
    return file;
}

/// The data for a new process between fork and exec, prepared because memory cannot be allocated there: another thread
/// may hold the allocator's lock.
struct Start {
    std::vector<const char*> words, environment;
    int in = -1, out = -1, err = -1, report = -1, note = -1, request = -1, told = -1;
    const ProcessJob* limited_by = nullptr;  ///< null: no limits, and the program may outlive this process
};

void limit(int resource, rlim_t value, rlim_t more = 0) {
    const rlimit both{value, value + more};
    setrlimit(__rlimit_resource_t(resource), &both);
}

/// Makes the kernel apply this filter to each further system call. Returns false on failure; errno has the reason.
bool take_filter(const std::string& calls) {
    const sock_fprog program{static_cast<unsigned short>(calls.size() / sizeof(sock_filter)),
                             reinterpret_cast<sock_filter*>(const_cast<char*>(calls.data()))};
    return calls.empty() || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

/// Moves the new process into a control group. Returns false on failure; errno has the reason.
bool join(const char* group) {
    const int folder = open(group, O_PATH | O_DIRECTORY | O_CLOEXEC);
    const int processes = openat(folder, "cgroup.procs", O_WRONLY | O_CLOEXEC);
    return write(processes, "0", 1) == 1;  // exec closes both descriptors
}

/// Applies the limits, in the new process. Returns false on failure; errno has the reason.
bool take_limits(const ProcessJob& job) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (!job.group.empty() && !join(job.group.c_str())) return false;  // needs the rights that are given up below
    // When the machine runs out of memory, the kernel must kill this process, and no other.
    if (const int score = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC); score >= 0) {
        [[maybe_unused]] const ssize_t written = write(score, "1000", 4);
        close(score);
    }
    limit(RLIMIT_CPU, rlim_t(job.limits.cpu), 1);  // SIGXCPU, then SIGKILL a second later
    limit(RLIMIT_AS, job.limits.memory);
    limit(RLIMIT_FSIZE, job.limits.file);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_NOFILE, 256);
    if (job.as_nobody && geteuid() == 0) {
        // Direct system calls: the library's wrappers would signal other threads, which do not exist after a fork.
        if (syscall(SYS_setgroups, 0, nullptr) != 0 || syscall(SYS_setresgid, nobody, nobody, nobody) != 0 ||
            syscall(SYS_setresuid, nobody, nobody, nobody) != 0)
            return false;
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // a change of user resets it
    }
    prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
    return take_filter(job.calls);
}

/// Runs the program in the new process; does not return.
[[noreturn]] void become(const Start& s) {
    setsid();
    dup2(s.in, 0), dup2(s.out, 1), dup2(s.err, 2);
    dup3(s.told, told_descriptor, O_CLOEXEC);  // exec closes it, which tells the parent that the program has started
    if (s.report >= 0)
        dup2(s.report, report_descriptor);
    else
        close(report_descriptor);
    if (s.note >= 0)
        dup2(s.note, note_descriptor);
    else
        close(note_descriptor);
    if (s.request >= 0) dup2(s.request, request_descriptor);
    // Close all other descriptors.
    syscall(SYS_close_range, told_descriptor + 1, request_descriptor - 1, 0);
    syscall(SYS_close_range, request_descriptor + (s.request >= 0 ? 1 : 0), ~0U, 0);
    if (!s.limited_by || take_limits(*s.limited_by))
        execvpe(s.words[0], const_cast<char* const*>(s.words.data()), const_cast<char* const*>(s.environment.data()));
    const int reason = errno;
    [[maybe_unused]] const ssize_t written = write(told_descriptor, &reason, sizeof reason);
    _exit(126);
}

/// Waits for a process. Returns its status as the system reports it.
int wait_for(pid_t process) {
    int status = 0;
    while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

/// Starts a program in a session of its own, and returns when it runs. Throws Error if it cannot be started.
pid_t spawn(Start s) {
    Pipe told;
    s.told = told.write;
    // Copy the ends above all target numbers, so that dup2 cannot overwrite one that is still needed.
    std::vector<Descriptor> copies;
    for (int* end : {&s.in, &s.out, &s.err, &s.report, &s.note, &s.request, &s.told}) {
        if (*end < 0) continue;
        *end = copies.emplace_back(fcntl(*end, F_DUPFD_CLOEXEC, request_descriptor + 1));
        if (*end < 0) throw Error(fmt::format("no descriptor: {}", std::strerror(errno)));
    }
    const pid_t process = fork();
    if (process == 0) become(s);
    if (process < 0) throw Error(fmt::format("no new process: {}", std::strerror(errno)));
    copies.clear();
    told.write.close();
    int reason = 0;
    if (!read_all(told.read, &reason, sizeof reason)) return process;
    wait_for(process);
    throw Error(fmt::format("cannot start {}: {}", s.words[0], std::strerror(reason)));
}

/// Collects the bytes that a running process writes into a pipe.
struct Stream {
    std::string& into;
    size_t kept;              ///< number of first bytes to keep
    size_t max = ~size_t{0};  ///< number of bytes that is not too much output
    bool is_open = true;
    size_t taken = 0;
    Pipe pipe = {};

    bool floods() const { return taken > max; }

    /// Reads all bytes that are available now.
    void take() {
        char block[output_block];
        for (pollfd end{pipe.read, POLLIN, 0}; is_open && !floods() && poll(&end, 1, 0) > 0;) {
            const ssize_t got = read(pipe.read, block, sizeof block);
            if (got < 0 && errno == EINTR) continue;
            is_open = got > 0;
            if (!is_open) return;
            taken += size_t(got);
            if (into.size() < kept) into.append(block, std::min(size_t(got), kept - into.size()));
        }
    }
};

/// A running program with its pipes.
class Running {
public:
    explicit Running(const ProcessJob& job) : job_(job) {}

    ProcessResult run() {
        const auto begin = Clock::now();
        launch();
        watch(begin + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(job_.limits.wall)));
        kill(-process_, SIGKILL);
        kill(process_, SIGKILL);
        if (!has_ended_) status_ = wait_for(process_);
        result_.wall = std::chrono::duration<double>(Clock::now() - begin).count();
        if (!result_.stopped)
            result_.exit_with(WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_), job_.limits.cpu);
        return std::move(result_);
    }

private:
    void launch() {
        const Descriptor in = file_in_memory(job_.input);
        Descriptor note(-1);
        if (!job_.note.empty()) note = file_in_memory(job_.note);
        std::vector<std::string> environment;
        if (!job_.environment.contains("PATH")) environment.push_back("PATH=/usr/bin:/bin");
        for (const auto& [name, value] : job_.environment) environment.push_back(name + "=" + value);
        Start s;
        for (const std::string& word : job_.command) s.words.push_back(word.c_str());
        for (const std::string& word : environment) s.environment.push_back(word.c_str());
        s.words.push_back(nullptr), s.environment.push_back(nullptr);
        s.in = in, s.out = out_.pipe.write, s.err = err_.pipe.write;
        if (job_.reports) s.report = report_.pipe.write;
        s.note = note;
        if (!job_.request.empty()) s.request = wire_.theirs;
        s.limited_by = &job_;
        process_ = spawn(s);
        for (Stream* stream : streams_) stream->pipe.write.close();
        wire_.theirs.close();
    }

    /// Returns when the program has ended or a limit is reached.
    void watch(Clock::time_point deadline) {
        while (!has_ended_) {
            const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
            if (left <= 0) return stop(Ending::out_of_time);
            wait_for_news(int(std::min<int64_t>(left, 1000)));
            // Do not wait for the end of the pipes: a child that is left behind may keep them open.
            has_ended_ = waitpid(process_, &status_, WNOHANG) == process_;
            for (Stream* stream : streams_) stream->take();
            if (out_.floods() || err_.floods()) return stop(Ending::too_much_output);
        }
    }

    void wait_for_news(int milliseconds) {
        std::vector<pollfd> ends;
        for (const Stream* stream : streams_)
            if (stream->is_open) ends.push_back({stream->pipe.read, POLLIN, 0});
        // All pipes are closed, and the end of the program alone does not wake poll().
        if (ends.empty()) milliseconds = 1;
        const bool sends = wire_.ours >= 0 && !job_.request.empty() && result_.output.starts_with(job_.asks);
        if (sends) ends.push_back({wire_.ours, POLLOUT, 0});
        poll(ends.data(), ends.size(), milliseconds);
        if (sends && ends.back().revents) send_request();
    }

    /// Sends as much as possible now. Closes the socket at the end of the request, or when the reader has gone.
    void send_request() {
        const std::string_view rest = std::string_view(job_.request).substr(sent_);
        const ssize_t sent = send(wire_.ours, rest.data(), rest.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (sent > 0) sent_ += size_t(sent);
        const bool later = sent < 0 && (errno == EAGAIN || errno == EINTR);
        if (sent_ == job_.request.size() || (sent < 0 && !later)) wire_.ours.close();
    }

    void stop(Ending ending) { result_.stopped = true, result_.ending = ending; }

    const ProcessJob& job_;
    ProcessResult result_;
    Stream out_{result_.output, job_.limits.output, job_.limits.output};
    Stream err_{result_.errors, size_t{64} << 10, max_errors};
    Stream report_{result_.report, size_t{4} << 10};
    const std::array<Stream*, 3> streams_ = {&out_, &err_, &report_};
    Wire wire_;
    size_t sent_ = 0;  ///< bytes of the request
    pid_t process_ = -1;
    int status_ = 0;
    bool has_ended_ = false;
};

}  // namespace

const char* name_of(Ending ending) {
    constexpr const char* names[] = {"exited", "crashed", "out of time", "out of memory", "too much output", "failed"};
    return names[int(ending)];
}

void ProcessResult::exit_with(int shell_code, double cpu_limit) {
    code = shell_code > 128 ? shell_code - 128 : shell_code;
    ending = Ending::exited;
    if (shell_code <= 128) return;
    const bool is_over = code == SIGXCPU || (code == SIGKILL && wall >= cpu_limit);
    ending = is_over ? Ending::out_of_time : Ending::crashed;
}

ProcessResult run_process(const ProcessJob& job) {
    try {
        return Running(job).run();
    } catch (const Error& error) {
        return {.ending = Ending::failed, .errors = error.what()};
    }
}

Pipe::Pipe() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw Error(fmt::format("no pipe: {}", std::strerror(errno)));
    read = Descriptor(ends[0]), write = Descriptor(ends[1]);
}

bool can_copy_process() { return true; }

ChildProcess::ChildProcess(const std::function<void()>& work) {
    std::fflush(nullptr);  // or buffered output would be written twice
    process_ = fork();
    if (process_ < 0) throw Error(fmt::format("no new process: {}", std::strerror(errno)));
    if (process_ > 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    int code = 0;
    try {
        work();
    } catch (...) {
        code = 1;
    }
    std::fflush(nullptr);
    _exit(code);
}

ChildProcess::~ChildProcess() {
    if (process_ < 0) return;
    kill(process_, SIGKILL);
    wait_for(process_);
}

ChildEnd ChildProcess::wait() {
    const int status = wait_for(process_);
    process_ = -1;
    return {.code = WEXITSTATUS(status), .crash = WIFSIGNALED(status) ? strsignal(WTERMSIG(status)) : ""};
}

void ChildProcess::abort() { kill(process_, SIGABRT); }

void become_program(const std::vector<std::string>& command) {
    std::vector<char*> words;
    for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
    words.push_back(nullptr);
    execvp(words[0], words.data());
}

bool open_on_desktop(const fs::path& wanted) { return start_on_desktop({"xdg-open", fs::absolute(wanted).string()}); }

bool start_on_desktop(const std::vector<std::string>& command) {
    if (command.empty() || !os::has_display()) return false;
    // Silent and without limits, as it may run for as long as the browser does.
    const Descriptor null(open("/dev/null", O_RDWR | O_CLOEXEC));
    Start s{.words = {}, .environment = {}, .in = null, .out = null, .err = null};
    for (const std::string& word : command) s.words.push_back(word.c_str());
    s.words.push_back(nullptr);
    for (char** variable = environ; *variable; ++variable) s.environment.push_back(*variable);
    s.environment.push_back(nullptr);
    try {
        spawn(s);
        return true;
    } catch (const Error&) {
        return false;
    }
}

}  // namespace relief
