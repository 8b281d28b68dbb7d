// Runs an untrusted command, isolated and limited.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/core/base/process.h"

namespace relief::grade {

/// How a command is isolated from the machine, the strongest first.
/// `groups`: as `namespaces`, and a control group limits the memory and the number of all its processes together,
/// including files in memory.
/// `namespaces`: bubblewrap gives it its own users, processes, network, mounts and host name; it sees only named files.
/// `limits`: only its time and the memory of each process are limited. It can read the files that this process
/// can read, write where anybody may write, and leave processes behind.
enum class Isolation { groups, namespaces, limits };
const char* name_of(Isolation isolation);

struct IsolationReport {
    Isolation level = Isolation::limits;
    std::string reason;       ///< why the level is not higher, as part of a sentence; empty for `groups`
    std::string remedy = {};  ///< lines that say how to raise it, with files to save; or empty
};
/// Tests whether namespaces and control groups work here; takes a few milliseconds. Returns `limits` if the environment
/// has RELIEF_NO_NAMESPACES (for tests: it can lower the level, never raise it). Its value is then the root folder for
/// refused_namespaces().
IsolationReport probe_isolation();

/// Explains that bubblewrap may make no namespaces. `said` is its message. Finds the cause in files under `root`: the
/// setting of AppArmor (Ubuntu since 23.10: kernel.apparmor_restrict_unprivileged_userns), and the marks of Docker and
/// Podman. Source: Ubuntu 24.04 release notes, "Unprivileged user namespace restrictions".
IsolationReport refused_namespaces(const std::string& said, const std::filesystem::path& root = "/");

/// The files that a command may see, and the processes that it may start.
struct Confinement {
    Isolation isolation = Isolation::namespaces;
    std::vector<std::filesystem::path> readable = {};  ///< visible under the same paths, besides /usr
    /// The maximum number of processes, threads included. Not applied with `limits`: the system would count all
    /// processes of the user on the machine.
    int processes = 64;
    bool makes_processes = true;  ///< false: it can start threads but no other process, at every level
};

/// Runs an untrusted command like run_process(). If we are root, it runs as nobody. call_filter() refuses system calls
/// that it never needs (system_calls.h). With namespaces, all its processes end with it, and it can write only to its
/// own /tmp, whose size is at most `limits.file`. With control groups, all its processes and files share
/// `limits.memory`.
ProcessResult run_sandboxed(ProcessJob job, const Confinement& confinement);

}  // namespace relief::grade
