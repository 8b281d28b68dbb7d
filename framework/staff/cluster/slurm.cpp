#include "framework/staff/cluster/slurm.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <map>

#include "framework/core/base/error.h"
#include "framework/core/base/process.h"
#include "framework/core/base/text.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// Returns this process's environment without the seed, because Slurm stores a job's environment; class.json has the
/// seed. Also removes Slurm's variables of the current job, which the new job would otherwise inherit.
std::map<std::string, std::string> environment_of_jobs() {
    std::map<std::string, std::string> all;
    for (char** variable = environ; *variable; ++variable) {
        const std::string text = *variable;
        const size_t equals = text.find('=');
        const std::string name = text.substr(0, equals);
        if (equals == std::string::npos || name == "RELIEF_SEED") continue;
        if (name.starts_with("SLURM_") && name != "SLURM_CONF" && name != "SLURM_CLUSTERS") continue;
        all[name] = text.substr(equals + 1);
    }
    return all;
}

ProcessResult run_slurm(const Words& command) {
    return run_process({.command = command, .environment = environment_of_jobs(), .limits = {.wall = 120, .cpu = 60}});
}

}  // namespace

bool has_slurm() {
    const char* const path = std::getenv("PATH");
    for (const std::string& folder : split(path ? path : "", ':'))
        if (!folder.empty() && access((fs::path(folder) / "sbatch").c_str(), X_OK) == 0) return true;
    return false;
}

std::optional<int> processors_from_slurm() {
    if (!std::getenv("SLURM_JOB_ID")) return {};
    for (const char* name : {"SLURM_CPUS_PER_TASK", "SLURM_CPUS_ON_NODE"}) {
        const char* const text = std::getenv(name);
        if (!text || !*text) continue;
        const auto number = parse_int(text);
        if (!number || *number < 1) throw UsageError(fmt::format("{} is '{}', not a number of processors", name, text));
        return number;
    }
    return {};
}

std::string submit_job(const Words& options, const Words& script) {
    // Our own limits apply to sbatch, and must not propagate to the job.
    Words command = {"sbatch", "--parsable", "--propagate=NONE"};
    command.insert(command.end(), options.begin(), options.end());
    command.insert(command.end(), script.begin(), script.end());
    const ProcessResult done = run_slurm(command);
    const std::string said = done.errors.substr(0, done.errors.find('\n'));
    if (!done.succeeded()) throw Error("Slurm takes no job: " + printable(said.empty() ? name_of(done.ending) : said));
    const std::string job = done.output.substr(0, done.output.find_first_of(";\n"));  // "12;cluster"
    if (!parse_int(job)) throw Error(fmt::format("sbatch names no job, but says '{}'", printable(done.output)));
    return job;
}

std::optional<std::set<std::string>> queued_jobs() {
    const ProcessResult done = run_slurm({"squeue", "--noheader", "--user=" + std::to_string(getuid()), "--format=%F"});
    if (!done.succeeded()) return {};
    const Words jobs = split(done.output, '\n');
    return std::set<std::string>(jobs.begin(), jobs.end());
}

}  // namespace relief::grade
