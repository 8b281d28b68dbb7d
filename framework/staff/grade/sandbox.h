// Runs an untrusted command, isolated and limited.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/base/process.h"

namespace relief {

/// How a command is isolated from the machine, the best first. `groups`: as `namespaces`; and a control group limits
/// the memory and the number of all its processes together, files in memory included. `namespaces`: bubblewrap gives it
/// users, processes, network, mounts and host name of its own; it sees only the named files. `limits`: only its time
/// and the memory of each process are limited. It can read what we can read, write where anybody may write, and leave
/// processes behind.
enum class Isolation { groups, namespaces, limits };
const char* name_of(Isolation isolation);

struct IsolationReport {
    Isolation level = Isolation::limits;
    std::string reason;  ///< why it is no better, a sentence's part; empty for `groups`
};
/// Tries whether namespaces and control groups work here; takes a few milliseconds. If the environment has
/// RELIEF_NO_NAMESPACES, the answer is `limits` (for tests: it can lower the level, never raise it).
IsolationReport probe_isolation();

/// What a command may see and start.
struct Confinement {
    Isolation isolation = Isolation::namespaces;
    std::vector<std::filesystem::path> readable = {};  ///< visible under the same paths, besides /usr
    /// The largest number of processes, threads included; not with limits alone: the system would count all processes
    /// of the user on the machine.
    int processes = 64;
    bool makes_processes = true;  ///< false: it can start threads, and no other process, at either level
};

/// Runs an untrusted command as run_process() does; root runs it as nobody, and call_filter() refuses what it never
/// needs (system_calls.h). With namespaces, all its processes end with it, and it can write only to its own /tmp, whose
/// size is at most `limits.file`. With control groups, all its processes and files together have `limits.memory`.
ProcessResult run_sandboxed(ProcessJob job, const Confinement& confinement);

}  // namespace relief
