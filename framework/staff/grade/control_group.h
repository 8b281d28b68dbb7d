// Linux's control groups (cgroups, version 2): one limit for all processes of a command together.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace relief::grade {

/// Returns why this process cannot make control groups; empty if it can. It can if it was given a group to divide
/// ("delegated"), as by `systemd-run --user --scope --property=Delegate=yes`. The first call prepares that group: since
/// a group with limited children must not contain processes itself, its processes move into a group below it.
const std::string& control_groups_missing();

/// A control group for one command, below the group of this process.
class ControlGroup {
public:
    /// `memory`: upper bound in bytes, including files in memory and the kernel's data for each file, without swap.
    /// `processes`: upper bound, threads included. Throws Error if control_groups_missing() has a reason, or if the
    /// system cannot make the group.
    ControlGroup(size_t memory, int processes);
    /// Kills all remaining processes of the group.
    ~ControlGroup();
    ControlGroup(const ControlGroup&) = delete;
    ControlGroup& operator=(const ControlGroup&) = delete;

    const std::filesystem::path& folder() const { return folder_; }
    /// Returns whether the system killed the group because it ran out of memory. All its processes end then.
    bool ran_out_of_memory() const;

private:
    std::filesystem::path folder_;
};

}  // namespace relief::grade
