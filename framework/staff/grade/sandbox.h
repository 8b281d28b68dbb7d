// Runs an untrusted command, isolated and limited.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/base/process.h"

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

/// What a command sees and makes.
struct Confinement {
    Isolation isolation = Isolation::namespaces;
    std::vector<std::filesystem::path> readable = {};  ///< seen at the same places, besides /usr
    /// With namespaces. By limits alone nothing bounds them: what the system counts for us there are all processes of
    /// the user on the whole machine, whoever has started them. See ProcessJob::makes_processes.
    int processes = 64;
};

/// Runs an untrusted command as run_process() does; root runs it as nobody. With namespaces it ends with every process
/// that it has made, `makes_processes` does not count, and `limits.file` bounds the only folder that it can write to,
/// /tmp, which nobody else sees.
ProcessResult run_sandboxed(ProcessJob job, const Confinement& confinement);

}  // namespace relief
