// Linux's control groups (cgroups, version 2): one limit for all processes of a command together.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace relief {

/// Why this process may make no control groups, or empty if it may: then it has been given a group to divide
/// ("delegated"), as `systemd-run --user --scope --property=Delegate=yes` does. The first call prepares that group: a
/// group that limits others may hold no process itself, so its processes move into a group below it.
const std::string& control_groups_missing();

/// A group below ours, for one command.
class ControlGroup {
public:
    /// `memory`: bytes, with files in memory and what the kernel keeps for each file; without swap. `processes`: with
    /// their threads. Throws Error where control_groups_missing() has a reason, or the system makes no group.
    ControlGroup(size_t memory, int processes);
    /// Ends what still runs in it.
    ~ControlGroup();
    ControlGroup(const ControlGroup&) = delete;
    ControlGroup& operator=(const ControlGroup&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    /// Whether the system has ended it because its memory was used up. All its processes end then.
    bool ran_out_of_memory() const;

private:
    std::filesystem::path folder_;
};

}  // namespace relief
