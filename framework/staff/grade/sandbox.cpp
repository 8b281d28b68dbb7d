#include "framework/staff/grade/sandbox.h"

#include <fmt/format.h>

#include <cstdlib>
#include <optional>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/staff/grade/control_group.h"
#include "framework/staff/grade/system_calls.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Allows bubblewrap, and no other program, to make namespaces of users.
constexpr const char* apparmor_profile = R"(abi <abi/4.0>,
include <tunables/global>

profile relief-bwrap /usr/bin/bwrap flags=(unconfined) {
  userns,
}
)";

/// Processes of bubblewrap itself, which a control group counts too.
constexpr int wrapping_processes = 3;

Words bubblewrap(const ProcessJob& job, const Confinement& confinement) {
    Words words = {"/usr/bin/bwrap",
                   "--unshare-all",
                   "--unshare-user",
                   "--disable-userns",
                   "--die-with-parent",
                   "--new-session",
                   "--clearenv",
                   "--hostname",
                   "relief",
                   "--json-status-fd",
                   std::to_string(report_descriptor),
                   "--seccomp",
                   std::to_string(note_descriptor),
                   "--ro-bind",
                   "/usr",
                   "/usr"};
    // Top folders that are links into /usr stay links.
    std::error_code ignored;
    for (const char* folder : {"/bin", "/lib", "/lib32", "/lib64", "/sbin"})
        if (fs::is_symlink(folder, ignored))
            words.insert(words.end(), {"--symlink", fs::read_symlink(folder, ignored).string(), folder});
        else
            words.insert(words.end(), {"--ro-bind-try", folder, folder});
    // The linker's cache, and the links behind names such as /usr/bin/c++.
    for (const char* path : {"/etc/ld.so.cache", "/etc/alternatives"})
        words.insert(words.end(), {"--ro-bind-try", path, path});
    words.insert(words.end(), {"--dev", "/dev", "--size", std::to_string(job.limits.file), "--tmpfs", "/tmp"});
    for (const fs::path& path : confinement.readable)
        words.insert(words.end(), {"--ro-bind", path.string(), path.string()});
    words.insert(words.end(), {"--setenv", "PATH", "/usr/bin:/bin"});
    for (const auto& [name, value] : job.environment) words.insert(words.end(), {"--setenv", name, value});
    // The new root and /dev are in memory, too, so make them read-only.
    words.insert(words.end(), {"--remount-ro", "/dev", "--remount-ro", "/", "--chdir", "/tmp"});
    // The number of processes counts inside the new user's namespace, so it is set there and not before.
    words.insert(words.end(), {"/usr/bin/prlimit", "--nproc=" + std::to_string(confinement.processes), "--"});
    words.insert(words.end(), job.command.begin(), job.command.end());
    return words;
}

/// Finds the number after "exit-code" in bubblewrap's status. Returns false if the command never started.
bool find_exit_code(const std::string& status, int& code) {
    const size_t at = status.find("\"exit-code\":");
    if (at == std::string::npos) return false;
    code = std::atoi(status.c_str() + at + 12);
    return true;
}

}  // namespace

const char* name_of(Isolation isolation) {
    constexpr const char* names[] = {"namespaces and control groups", "namespaces", "limits"};
    return names[int(isolation)];
}

IsolationReport refused_namespaces(const std::string& said, const fs::path& root) {
    IsolationReport report{Isolation::limits, "this system does not let bubblewrap make namespaces (" + said + ")"};
    std::error_code ignored;
    const fs::path setting = root / "proc/sys/kernel/apparmor_restrict_unprivileged_userns";
    const bool by_apparmor = fs::exists(setting, ignored) && read_file(setting).starts_with('1'),
               in_container =
                   fs::exists(root / ".dockerenv", ignored) || fs::exists(root / "run/.containerenv", ignored);
    if (in_container) {
        report.reason += ": this container may not make them";
        report.remedy =
            "start the container with --security-opt seccomp=unconfined --security-opt apparmor=unconfined\n";
    }
    if (by_apparmor) {
        report.reason += in_container ? ", nor does AppArmor on its host allow them" : ": AppArmor forbids them";
        report.remedy += fmt::format(
            "{}save the lines below as /etc/apparmor.d/relief-bwrap, then: "
            "sudo apparmor_parser -r /etc/apparmor.d/relief-bwrap\n{}",
            in_container ? "and on the host " : "", apparmor_profile);
    }
    return report;
}

IsolationReport probe_isolation() {
    std::error_code ignored;
    if (const char* const root = std::getenv("RELIEF_NO_NAMESPACES"))
        return refused_namespaces("RELIEF_NO_NAMESPACES is set", root);
    if (!fs::exists("/usr/bin/bwrap", ignored))
        return {Isolation::limits, "there is no /usr/bin/bwrap: install the Debian package bubblewrap"};
    const auto problem = [](Isolation level) -> std::string {
        const ProcessResult tried =
            run_sandboxed({.command = {"/usr/bin/true"}, .limits = {.wall = 10}}, {.isolation = level});
        return tried.succeeded() ? "" : tried.errors.substr(0, tried.errors.find('\n'));
    };
    if (const std::string reason = problem(Isolation::namespaces); !reason.empty()) return refused_namespaces(reason);
    const std::string reason = problem(Isolation::groups);
    return {reason.empty() ? Isolation::groups : Isolation::namespaces, reason};
}

ProcessResult run_sandboxed(ProcessJob job, const Confinement& confinement) {
    const bool wrapped = confinement.isolation != Isolation::limits;
    std::optional<ControlGroup> group;
    try {
        if (confinement.isolation == Isolation::groups)
            job.group = group.emplace(job.limits.memory, confinement.processes + wrapping_processes).folder();
    } catch (const Error& error) {
        return {.ending = Ending::failed, .errors = error.what()};
    }
    job.as_nobody = true;
    static const std::string with_processes = call_filter(true), with_threads = call_filter(false);
    job.calls = confinement.makes_processes ? with_processes : with_threads;
    if (wrapped) {
        job.command = bubblewrap(job, confinement);
        job.environment.clear();                  // bubblewrap's arguments set the command's environment
        job.note = std::exchange(job.calls, {});  // only for the command: bubblewrap itself needs the refused calls
        job.reports = true;
    }
    ProcessResult result = run_process(job);
    if (group && group->ran_out_of_memory()) {
        result.ending = Ending::out_of_memory;
    } else if (wrapped && !result.stopped && result.ending != Ending::failed) {
        int code = result.code;
        if (find_exit_code(result.report, code)) {
            result.exit_with(code, job.limits.cpu);
        } else {
            result.ending = Ending::failed;
            if (result.errors.empty()) result.errors = fmt::format("bubblewrap ended with {}", code);
        }
    }
    return result;
}

}  // namespace relief::grade
