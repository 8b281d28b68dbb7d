#include "framework/staff/grade/control_group.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <thread>

#include "framework/core/base/descriptor.h"
#include "framework/core/base/error.h"
#include "framework/core/base/process.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

/// The group that receives the processes of the group to divide.
constexpr const char* graders_name = "relief-graders";

/// Writes a text to a control file in one call, as the kernel requires. Returns false on failure and sets errno.
bool set(const fs::path& file, const std::string& text) {
    const Descriptor opened(open(file.c_str(), O_WRONLY | O_CLOEXEC));
    return opened >= 0 && write(opened, text.data(), text.size()) == ssize_t(text.size());
}

/// Returns the text of a file; empty if it cannot be read.
std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

bool has_word(const fs::path& file, const std::string& wanted) {
    std::ifstream words(file);
    for (std::string word; words >> word;)
        if (word == wanted) return true;
    return false;
}

bool limits_memory_and_processes(const fs::path& controllers) {
    return has_word(controllers, "memory") && has_word(controllers, "pids");
}

/// Returns the mount point of cgroup version 2; empty if it is not mounted.
fs::path mount_point() {
    std::ifstream mounts("/proc/self/mounts");
    for (std::string device, folder, type, rest; mounts >> device >> folder >> type && std::getline(mounts, rest);)
        if (type == "cgroup2") return folder;
    return {};
}

/// Returns the group of this process; empty if it has none.
fs::path own_group() {
    const fs::path root = mount_point();
    std::ifstream groups("/proc/self/cgroup");
    for (std::string line; !root.empty() && std::getline(groups, line);)
        if (line.starts_with("0::/")) return root / fs::path(line.substr(4));
    return {};
}

/// Returns whether systemd has delegated the group to us. Write access does not prove that: a desktop user owns all
/// groups of the desktop, but systemd manages them.
bool is_delegated(const fs::path& group) {
    // The system's systemd marks delegated groups. Only root can read the older mark, trusted.delegate.
    for (const char* name : {"user.delegate", "trusted.delegate"}) {
        char mark = '0';
        if (getxattr(group.c_str(), name, &mark, 1) == 1 && mark == '1') return true;
    }
    if (geteuid() == 0 || access((group / "cgroup.subtree_control").c_str(), W_OK) != 0) return false;
    // A user's systemd cannot set the mark, but answers a query.
    ProcessJob question{.command = {"/usr/bin/systemctl", "--user", "show", "--property=Delegate", "--value", "--",
                                    group.filename().string()},
                        .limits = {.wall = 5}};
    for (const char* name : {"XDG_RUNTIME_DIR", "DBUS_SESSION_BUS_ADDRESS"})
        if (const char* const value = std::getenv(name)) question.environment[name] = value;
    return run_process(question).output != "no\n";
}

/// Moves all processes. Returns false if one cannot be moved, and sets errno.
bool move_processes(const fs::path& from, const fs::path& to) {
    // Processes may start others during the move, so read the list until it is empty.
    for (std::string all = text_of(from / "cgroup.procs"); !all.empty(); all = text_of(from / "cgroup.procs")) {
        std::istringstream processes(all);
        for (std::string process; processes >> process;)
            if (!set(to / "cgroup.procs", process) && errno != ESRCH) return false;
    }
    return true;
}

struct Preparation {
    fs::path group;       ///< the parent of new groups
    std::string missing;  ///< why no group can be made; empty if one can
};

Preparation prepare() {
    fs::path group = own_group();
    if (group.empty()) return {{}, "this system has no control groups of version 2"};
    // An earlier grader already moved the shell that started this one.
    const bool is_prepared = group.filename() == graders_name;
    if (is_prepared) group = group.parent_path();
    if (!is_delegated(group))
        return {{},
                "this process may not divide its own; start the grader with "
                "`systemd-run --user --scope --property=Delegate=yes`"};
    if (!limits_memory_and_processes(group / "cgroup.controllers"))
        return {{}, "that of this process limits no memory, or no processes"};
    if (is_prepared && limits_memory_and_processes(group / "cgroup.subtree_control")) return {group, ""};
    const fs::path graders = group / graders_name;
    if ((mkdir(graders.c_str(), 0755) != 0 && errno != EEXIST) || !move_processes(group, graders) ||
        !set(group / "cgroup.subtree_control", "+memory +pids"))
        return {{}, fmt::format("that of this process cannot be divided: {}", std::strerror(errno))};
    return {group, ""};
}

const Preparation& prepared() {
    static const Preparation once = prepare();
    return once;
}

}  // namespace

const std::string& control_groups_missing() { return prepared().missing; }

ControlGroup::ControlGroup(size_t memory, int processes) {
    static std::atomic<int> count = 0;
    if (!prepared().missing.empty()) throw Error("no control group: " + prepared().missing);
    folder_ = prepared().group / fmt::format("relief-{}-{}", getpid(), ++count);
    if (mkdir(folder_.c_str(), 0755) != 0) throw Error(fmt::format("no control group: {}", std::strerror(errno)));
    // A system without swap has no such file.
    const bool without_swap = set(folder_ / "memory.swap.max", "0") || errno == ENOENT;
    if (!without_swap || !set(folder_ / "memory.max", std::to_string(memory)) ||
        !set(folder_ / "memory.oom.group", "1") || !set(folder_ / "pids.max", std::to_string(processes))) {
        const int reason = errno;
        rmdir(folder_.c_str());
        throw Error(fmt::format("no limits for a control group: {}", std::strerror(reason)));
    }
}

ControlGroup::~ControlGroup() {
    set(folder_ / "cgroup.kill", "1");
    // A group becomes removable shortly after its last process has ended.
    for (int i = 0; i < 500 && rmdir(folder_.c_str()) != 0 && errno == EBUSY; ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
}

bool ControlGroup::ran_out_of_memory() const {
    std::ifstream events(folder_ / "memory.events");
    for (std::string name, count; events >> name >> count;)
        if (name == "oom_kill") return count != "0";
    return false;
}

}  // namespace relief::grade
