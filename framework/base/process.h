// Processes: starts programs with limits and collects their output, and runs functions where a crash is not ours.
// No other file of the course starts processes. Each operating system has a file for it, as for system.h.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "framework/base/descriptor.h"

namespace relief {

struct ProcessLimits {
    double wall = 60, cpu = 60;        ///< seconds
    size_t memory = size_t{4} << 30;   ///< bytes of address space of each process
    size_t output = size_t{64} << 20;  ///< bytes on standard output
    size_t file = size_t{64} << 20;    ///< bytes of each file that it writes
};

/// Where a program reads its request, where it writes its report, and where it reads its note.
constexpr int request_descriptor = 97, report_descriptor = 3, note_descriptor = 4;

struct ProcessJob {
    std::vector<std::string> command = {};                ///< whole path first
    std::map<std::string, std::string> environment = {};  ///< all of it; PATH is the system's if not here
    std::string input = {};                               ///< on its standard input
    /// Comes on `request_descriptor` once the output begins with `asks`: nothing is there to be read before.
    std::string request = {}, asks = {};
    ProcessLimits limits = {};
    std::string calls = {};            ///< seccomp's filter of its system calls (struct sock_filter); empty: any call
    std::string note = {};             ///< a file on `note_descriptor`, unless empty
    std::filesystem::path group = {};  ///< the folder of the control group that it joins; empty: ours
    bool as_nobody = false;            ///< root gives its rights up
    bool reports = false;              ///< it writes to `report_descriptor`
};

/// `failed`: it never ran, and that is the machine's fault or ours.
enum class Ending { exited, crashed, out_of_time, out_of_memory, too_much_output, failed };
const char* name_of(Ending ending);

struct ProcessResult {
    Ending ending = Ending::failed;
    int code = 0;             ///< exit code, or the signal of a crash
    std::string output = {};  ///< at most limits.output
    std::string errors = {};  ///< the first 64 KiB of standard error, or why it failed
    double wall = 0;          ///< seconds
    std::string report = {};  ///< the first 4 KiB
    bool stopped = false;     ///< by us: for its time or its output

    /// Sets ending and code by an exit code as shells give it: 128 + the signal for a crash.
    void exit_with(int shell_code);
    bool succeeded() const { return ending == Ending::exited && code == 0; }
};

/// Runs it to its end, or ends it with those processes it has made that are still in its session. Does not throw.
ProcessResult run_process(const ProcessJob& job);

/// Throws Error if the system has none left.
struct Pipe {
    Pipe();
    Descriptor read{-1}, write{-1};
};

/// How a child process ended.
struct ChildEnd {
    int code = 0;            ///< exit code; 1 after an exception
    std::string crash = {};  ///< "Segmentation fault" if a signal ended it
};

/// A function that runs in a copy of this process; killed when the object goes, unless it has ended.
class ChildProcess {
public:
    /// Throws Error if no process can be made.
    explicit ChildProcess(const std::function<void()>& work);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    ChildEnd wait();

private:
    int process_;
};

/// Shows a file in the browser, or the program set for its type, and does not wait. False if there is no display, or
/// no xdg-open.
bool open_on_desktop(const std::filesystem::path& file);
/// The same with a program and its arguments, such as an editor. False if there is no display, or no such program.
bool start_on_desktop(const std::vector<std::string>& command);

}  // namespace relief
