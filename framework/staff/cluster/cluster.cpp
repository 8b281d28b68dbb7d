#include "framework/staff/cluster/cluster.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/core/base/text.h"
#include "framework/staff/cluster/slurm.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using Words = std::vector<std::string>;

fs::path place(const fs::path& folder) { return fs::absolute(folder).lexically_normal() / "slurm"; }

/// Writes a job's script. `--resume` makes each job continue from existing results.
std::string write_script(const fs::path& folder, const char* name, const char* comment, const std::string& shard,
                         const Words& options) {
    std::string text = fmt::format("#!/bin/bash\n# {}\nexec {} grade --resume -o {}{}", comment,
                                   quoted_for_shell(executable_path().string()),
                                   quoted_for_shell(place(folder).parent_path().string()), shard);
    for (const std::string& option : options) text += " " + quoted_for_shell(option);
    write_file(place(folder) / name, text + "\n");
    return (place(folder) / name).string();
}

/// Returns the job of a part, or the last job (part 0).
const QueuedJob* find_job(const std::vector<QueuedJob>& queue, const Cluster& cluster, int part) {
    for (const QueuedJob& job : queue)
        if (part > 0 ? job.job == cluster.parts_job && job.task == part : job.job == cluster.report_job) return &job;
    return nullptr;
}

/// Returns why a job ended without results: the last message of its grader, or the state that Slurm reports.
std::string reason_of(const fs::path& log, const QueuedJob* job) {
    std::string said;
    if (std::error_code unknown; fs::exists(log, unknown))
        for (const std::string& line : split(read_file(log), '\n'))
            if (line.starts_with("relief: ") || line.starts_with("slurmstepd: "))
                said = line.substr(line.find(' ') + 1);
    if (!job || job->state == "COMPLETED" || (job->state == "FAILED" && !said.empty())) return printable(said);
    std::string state = job->state;
    for (char& c : state) c = c == '_' ? ' ' : char(std::tolower(static_cast<unsigned char>(c)));
    return state;
}

/// Sets a part's state from its job; `job` is null if Slurm does not know it.
void set_state(PartState& part, const QueuedJob* job, bool slurm_answers, const fs::path& log) {
    if (job) {
        part.job = job->task ? fmt::format("{}_{}", job->job, *job->task) : job->job;
        if (!job->node.empty()) part.node = job->node;
    }
    if (part.submissions > 0 && part.results == part.submissions)
        part.state = "done";
    else if (job && job->runs())
        part.state = "runs";
    else if (job && job->waits())
        part.state = "waits", part.reason = job->reason;
    else if (slurm_answers || job)
        part.state = "failed", part.reason = reason_of(log, job);
    else
        part.state = "unknown";
}

}  // namespace

std::optional<Cluster> read_cluster(const fs::path& folder) {
    const fs::path file = place(folder) / "cluster.json", report = folder / "report.html";
    if (!fs::exists(file)) return {};
    try {
        const ordered_json json = ordered_json::parse(read_file(file, size_t{1} << 24));
        return Cluster{.parts = json.at("parts"),
                       .parts_job = json.at("job"),
                       .report_job = json.at("report"),
                       .has_report = fs::exists(report) && fs::last_write_time(report) >= fs::last_write_time(file)};
    } catch (const ordered_json::exception&) {
        throw Error({file}, "does not say which jobs were sent: remove its folder");
    }
}

Words jobs_at_work(const Cluster& cluster) {
    std::set<std::string> jobs;
    for (const QueuedJob& job : queued_jobs().value_or(std::vector<QueuedJob>{}))
        if ((job.job == cluster.parts_job || job.job == cluster.report_job) && !job.has_ended()) jobs.insert(job.job);
    return {jobs.begin(), jobs.end()};
}

Cluster send_class(const fs::path& folder, int parts, int jobs_at_a_time, const Words& options) {
    fs::remove_all(place(folder));
    make_folder(place(folder));
    fs::permissions(place(folder), fs::perms::owner_all);  // the jobs' logs contain marks
    std::string logs = place(folder).string();
    for (size_t at = 0; (at = logs.find('%', at)) != std::string::npos; at += 2) logs.replace(at, 1, "%%");
    const auto submit = [&](const char* name, const std::string& log, const std::string& more,
                            const std::string& script) {
        Words words = {fmt::format("--job-name=relief-{}", name), "--requeue", "--open-mode=append",
                       "--output=" + logs + "/" + log};
        if (jobs_at_a_time > 0) words.push_back(fmt::format("--cpus-per-task={}", jobs_at_a_time));
        words.push_back(more);
        return submit_job(words, {script});
    };
    Cluster cluster{.parts = parts, .parts_job = {}, .report_job = {}};
    cluster.parts_job = submit("part", "part-%a.log", fmt::format("--array=1-{}", parts),
                               write_script(folder, "part.sh", "A part of a class, sent by `relief grade --slurm`.",
                                            fmt::format(" --shard \"$SLURM_ARRAY_TASK_ID/{}\"", parts), options));
    cluster.report_job = submit("report", "last.log", "--dependency=afterany:" + cluster.parts_job,
                                write_script(folder, "last.sh",
                                             "Runs when the parts have ended: grades what has no result yet, and "
                                             "writes the report.",
                                             "", options));
    const ordered_json json = {
        {"schema", 2}, {"parts", parts}, {"job", cluster.parts_job}, {"report", cluster.report_job}};
    write_file_to_disk(place(folder) / "cluster.json", json.dump(2) + "\n");
    return cluster;
}

std::vector<PartState> part_states(const fs::path& folder, const Cluster& cluster, const ClassProgress& progress) {
    const auto queue = queued_jobs();
    const std::vector<QueuedJob> jobs = queue.value_or(std::vector<QueuedJob>{});
    std::vector<PartState> states;
    for (int part = 1; part <= cluster.parts; ++part) {
        PartState state;
        state.part = part;
        for (size_t i = size_t(part - 1); i < progress.marks.size(); i += size_t(cluster.parts)) {
            ++state.submissions;
            state.results += progress.marks[i].has_value();
        }
        set_state(state, find_job(jobs, cluster, part), queue.has_value(),
                  place(folder) / fmt::format("part-{}.log", part));
        states.push_back(std::move(state));
    }
    PartState last;
    set_state(last, find_job(jobs, cluster, 0), queue.has_value(), place(folder) / "last.log");
    if (cluster.has_report) last.state = "done", last.reason.clear();
    states.push_back(std::move(last));
    return states;
}

}  // namespace relief::grade
