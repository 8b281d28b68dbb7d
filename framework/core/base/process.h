// Processes: starts programs with limits and collects their output, and runs functions where a crash does not end this
// process. No other file of the course starts processes. Each operating system has its own implementation, as for
// system.h.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "framework/core/base/descriptor.h"

namespace relief {

struct ProcessLimits {
    double wall = 60, cpu = 60;        ///< seconds
    size_t memory = size_t{4} << 30;   ///< bytes of address space of each process
    size_t output = size_t{64} << 20;  ///< bytes on standard output
    size_t file = size_t{64} << 20;    ///< bytes of each file that it writes
};

/// The descriptors on which a program reads its request, writes its report, and reads its note.
constexpr int request_descriptor = 97, report_descriptor = 3, note_descriptor = 4;

struct ProcessJob {
    std::vector<std::string> command = {};                ///< the program's whole path first
    std::map<std::string, std::string> environment = {};  ///< complete; PATH is the system's default if missing
    std::string input = {};                               ///< on its standard input
    /// `request` is sent on `request_descriptor` once the output begins with `asks`. Before that, nothing can be read
    /// there.
    std::string request = {}, asks = {};
    ProcessLimits limits = {};
    std::string calls = {};            ///< seccomp filter of its system calls (struct sock_filter); empty: no filter
    std::string note = {};             ///< contents of a file on `note_descriptor`; empty: no file
    std::filesystem::path group = {};  ///< folder of the control group to join; empty: ours
    bool as_nobody = false;            ///< if this process is root, the program runs as nobody
    bool reports = false;              ///< the program writes to `report_descriptor`
};

/// `failed` means that the program never ran, through a fault of the machine or of this process.
enum class Ending { exited, crashed, out_of_time, out_of_memory, too_much_output, failed };
const char* name_of(Ending ending);

struct ProcessResult {
    Ending ending = Ending::failed;
    int code = 0;             ///< exit code, or the signal of a crash
    std::string output = {};  ///< at most limits.output
    std::string errors = {};  ///< the first 64 KiB of standard error, or the reason of a failure
    double wall = 0;          ///< seconds
    std::string report = {};  ///< the first 4 KiB
    bool stopped = false;     ///< by us, for its time or its output

    /// Sets `ending` and `code` from a shell's exit code, which is 128 + the signal for a crash. The system kills a
    /// program that ignores the signal for its limit of processor time, which cannot be before `wall` has that length.
    void exit_with(int shell_code, double cpu_limit);
    bool succeeded() const { return ending == Ending::exited && code == 0; }
};

/// Runs the program to its end or to a limit. Then kills what is left of its process group. Does not throw.
ProcessResult run_process(const ProcessJob& job);

/// A pipe with both ends. Throws Error if the system has none left.
struct Pipe {
    Pipe();
    Descriptor read{-1}, write{-1};
};

/// The end of a child process.
struct ChildEnd {
    int code = 0;            ///< exit code; 1 after an exception
    std::string crash = {};  ///< the signal's name, such as "Segmentation fault"; empty without a crash
};

/// Returns whether this system can copy a running process.
bool can_copy_process();

/// A function that runs in a copy of this process. The destructor kills the copy if it still runs. Where the system
/// cannot copy a process, the constructor runs the function, and a crash ends this process.
class ChildProcess {
public:
    /// Throws Error if the system cannot create a process.
    explicit ChildProcess(const std::function<void()>& work);
    ~ChildProcess();
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    ChildEnd wait();
    /// Ends the copy as std::abort() does, in its main thread.
    void abort();

private:
    int process_;
};

/// Continues as another program, found in PATH, with its arguments. Returns only if that fails.
void become_program(const std::vector<std::string>& command);

/// Shows a file in the browser, or in the program for its type, and does not wait. Returns false if there is no display
/// or, on Linux, no xdg-open.
bool open_on_desktop(const std::filesystem::path& file);
/// Starts a program with its arguments, such as an editor, likewise. Returns false if there is no display or no such
/// program.
bool start_on_desktop(const std::vector<std::string>& command);

}  // namespace relief
