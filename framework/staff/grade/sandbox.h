// Runs an untrusted command, isolated and limited.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace relief {

/// What keeps a command from the rest of the machine. `namespaces`: bubblewrap, with users, processes, network, mounts
/// and host name of its own, and no file to see but those named. `limits`: only bounds on what it uses; it can read
/// whatever we can, write where anybody may, and leave processes behind.
enum class Isolation { namespaces, limits };
const char* name_of(Isolation isolation);

struct IsolationReport {
    Isolation level = Isolation::limits;
    std::string reason;  ///< why it is no better, or empty
};
/// Tries it, in a few milliseconds. The environment's RELIEF_NO_NAMESPACES has it say that there are none (for tests:
/// less can be asked for, never more).
IsolationReport probe_isolation();

struct SandboxLimits {
    double wall = 60, cpu = 60;         ///< seconds
    size_t memory = size_t{4} << 30;    ///< bytes of address space of each process
    size_t output = size_t{64} << 20;   ///< bytes on standard output
    size_t scratch = size_t{64} << 20;  ///< bytes in the only folder it can write to, /tmp, which nobody else sees
    /// With namespaces. By limits alone nothing bounds them: what the system counts for us there are all processes of
    /// the user on the whole machine, whoever has started them. See SandboxJob::makes_processes.
    int processes = 64;
};

struct SandboxJob {
    std::vector<std::string> command;                ///< whole path first
    std::vector<std::filesystem::path> readable;     ///< seen at the same places, besides /usr
    std::map<std::string, std::string> environment;  ///< all of it, but for PATH
    std::string input;                               ///< on its standard input
    /// Comes on `request_descriptor` once the output begins with `asks`: nothing is there to be read before.
    std::string request = {}, asks = {};
    SandboxLimits limits;
    /// False: by limits alone it can start threads, and no other process.
    bool makes_processes = true;
};

/// `failed`: it never ran, and that is the machine's fault or ours.
enum class Ending { exited, crashed, out_of_time, out_of_memory, too_much_output, failed };
const char* name_of(Ending ending);

struct SandboxResult {
    Ending ending = Ending::failed;
    int code = 0;        ///< exit code, or the signal of a crash
    std::string output;  ///< at most limits.output
    std::string errors;  ///< the first 64 KiB of standard error, or why it failed
    double wall = 0;     ///< seconds
};

/// Runs it to its end, or ends it with all the processes it has made. Does not throw for what the command does.
SandboxResult run_sandboxed(const SandboxJob& job, Isolation isolation);

/// The same by limits alone and as the user that we are: for commands that are our own.
SandboxResult run_trusted(const SandboxJob& job);

}  // namespace relief
