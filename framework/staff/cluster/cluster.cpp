#include "framework/staff/cluster/cluster.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>
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

constexpr int last_jobs_in_all = 3;
constexpr const char *sent_variable = "RELIEF_SENT", *attempt_variable = "RELIEF_ATTEMPT";

fs::path place(const fs::path& folder) { return fs::absolute(folder).lexically_normal() / "slurm"; }

void write_cluster(const fs::path& folder, const Cluster& cluster) {
    ordered_json json = {{"schema", 1},
                         {"parts", cluster.parts},
                         {"options", cluster.options},
                         {"sent", ordered_json::array()},
                         {"has_ended", cluster.has_ended}};
    for (const Cluster::Sent& one : cluster.sent) json["sent"].push_back({{"job", one.job}, {"last", one.is_last}});
    write_file_to_disk(place(folder) / "cluster.json", json.dump(2) + "\n");
}

Cluster cluster_of(const fs::path& folder) {
    if (auto cluster = read_cluster(folder)) return *std::move(cluster);
    throw Error({folder}, "was never sent to Slurm");
}

std::string number_of(const char* variable) {
    const char* const text = std::getenv(variable);
    return text ? text : "";
}

/// Returns the command of a job. `--resume` makes each job continue from existing results.
std::string grade_command(const fs::path& folder, const std::string& rest, const Words& options) {
    std::string line = fmt::format("exec {} grade --resume -o {} {}", quoted_for_shell(executable_path().string()),
                                   quoted_for_shell(place(folder).parent_path().string()), rest);
    for (const std::string& option : options) line += " " + quoted_for_shell(option);
    return line + "\n";
}

void write_scripts(const fs::path& folder, int parts, const Words& options) {
    write_file(place(folder) / "part.sh",
               fmt::format("#!/bin/bash\n"
                           "# A part of a class, sent by `relief grade --slurm`: grades what has no result yet.\n"
                           "echo \"$SLURMD_NODENAME\" >>{}/part-\"$SLURM_ARRAY_TASK_ID\".nodes\n",
                           quoted_for_shell(place(folder).string())) +
                   grade_command(folder, fmt::format("--shard \"$SLURM_ARRAY_TASK_ID/{}\"", parts), options));
    write_file(place(folder) / "last.sh",
               fmt::format("#!/bin/bash\n"
                           "# Runs when the parts have ended: sends again those that lack results, or writes the "
                           "report.\n"
                           "export {}=$1 {}=$2  # how often parts were sent; which attempt at this job it is\n",
                           sent_variable, attempt_variable) +
                   grade_command(folder, fmt::format("--slurm {}", parts), options));
}

/// Returns sbatch's options for one job of a class.
Words options_of_job(const fs::path& folder, const Cluster& cluster, const std::string& name, const std::string& log) {
    std::string pattern = place(folder).string();
    for (size_t at = 0; (at = pattern.find('%', at)) != std::string::npos; at += 2) pattern.replace(at, 1, "%%");
    Words words = {"--job-name=" + name, "--requeue", "--open-mode=append", "--output=" + pattern + "/" + log};
    words.insert(words.end(), cluster.options.begin(), cluster.options.end());
    return words;
}

/// Returns the parts as sbatch writes a list: "1,2,5".
std::string list_of(const std::vector<int>& parts) {
    Words words;
    for (const int part : parts) words.push_back(std::to_string(part));
    return join(words, ",");
}

/// Adds sbatch's option to exclude these nodes, if there are any.
void add_excluded(Words& words, const std::set<std::string>& nodes) {
    if (!nodes.empty()) words.push_back("--exclude=" + join(Words(nodes.begin(), nodes.end()), ","));
}

void send_parts(const fs::path& folder, Cluster& cluster, const std::vector<int>& parts,
                const std::set<std::string>& without) {
    Words words = options_of_job(folder, cluster, "relief-part", "part-%a.log");
    words.push_back("--array=" + list_of(parts));
    add_excluded(words, without);
    cluster.sent.push_back({submit_job(words, {(place(folder) / "part.sh").string()}), false});
    write_cluster(folder, cluster);
}

void send_last(const fs::path& folder, Cluster& cluster, const LastJob& next, const Words& more) {
    Words words = options_of_job(folder, cluster, "relief-report", "last.log");
    words.insert(words.end(), more.begin(), more.end());
    cluster.sent.push_back({submit_job(words, {(place(folder) / "last.sh").string(), std::to_string(next.sent),
                                               std::to_string(next.attempt)}),
                            true});
    write_cluster(folder, cluster);
}

/// Returns the option to start after these jobs, whether they succeed or fail.
std::string after(const Words& jobs) { return "--dependency=afterany:" + join(jobs, ":"); }

/// Returns the nodes on which a part ran, the latest first.
Words nodes_of(const fs::path& folder, int part) {
    Words nodes;
    const fs::path file = place(folder) / fmt::format("part-{}.nodes", part);
    if (std::error_code unknown; fs::exists(file, unknown))
        for (const std::string& line : split(read_file(file, 1 << 20), '\n'))
            if (!line.empty()) nodes.insert(nodes.begin(), line);
    return nodes;
}

/// Returns the longest prefix of `nodes` that leaves at least one usable node. If `usable` is unknown, returns only the
/// first node.
std::set<std::string> avoidable(const Words& nodes, std::optional<std::set<std::string>> usable) {
    std::set<std::string> avoided;
    for (const std::string& node : nodes) {
        if (node.empty() || avoided.contains(node)) continue;
        if (usable) usable->erase(node);
        if (usable ? usable->empty() : !avoided.empty()) break;
        avoided.insert(node);
    }
    return avoided;
}

/// Returns the job of a part, or the last job (part 0). Prefers a running job, then the newest.
const QueuedJob* find_job(const std::vector<QueuedJob>& queue, const Cluster& cluster, int part) {
    const QueuedJob* newest = nullptr;
    for (auto sent = cluster.sent.rbegin(); sent != cluster.sent.rend(); ++sent)
        for (const QueuedJob& job : queue)
            if (job.job == sent->job && (part > 0 ? job.task == part : sent->is_last)) {
                if (job.runs()) return &job;
                if (!newest) newest = &job;
            }
    return newest;
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
    const fs::path file = place(folder) / "cluster.json";
    if (!fs::exists(file)) return {};
    try {
        const ordered_json json = ordered_json::parse(read_file(file, size_t{1} << 24));
        Cluster cluster{
            .parts = json.at("parts"), .options = json.at("options"), .sent = {}, .has_ended = json.at("has_ended")};
        for (const ordered_json& one : json.at("sent")) cluster.sent.push_back({one.at("job"), one.at("last")});
        return cluster;
    } catch (const ordered_json::exception&) {
        throw Error({file}, "does not say which jobs were sent: remove its folder");
    }
}

Words jobs_at_work(const Cluster& cluster) {
    std::set<std::string> jobs;
    for (const QueuedJob& job : queued_jobs().value_or(std::vector<QueuedJob>{}))
        for (const Cluster::Sent& sent : cluster.sent)
            if (job.job == sent.job && !job.has_ended()) jobs.insert(job.job);
    return {jobs.begin(), jobs.end()};
}

Cluster send_class(const fs::path& folder, int parts, int jobs_at_a_time, const Words& options) {
    fs::remove_all(place(folder));
    make_folder(place(folder));
    fs::permissions(place(folder), fs::perms::owner_all);  // the jobs' logs contain marks
    Cluster cluster{.parts = parts, .options = {}, .sent = {}};
    if (jobs_at_a_time > 0) cluster.options = {fmt::format("--cpus-per-task={}", jobs_at_a_time)};
    write_scripts(folder, parts, options);
    std::vector<int> all;
    for (int part = 1; part <= parts; ++part) all.push_back(part);
    send_parts(folder, cluster, all, {});
    send_last(folder, cluster, {}, {after({cluster.sent.back().job})});
    return cluster;
}

std::optional<LastJob> this_last_job() {
    const auto sent = parse_int(number_of(sent_variable)), attempt = parse_int(number_of(attempt_variable));
    if (!sent || !attempt) return {};
    return LastJob{*sent, *attempt};
}

void send_substitute(const fs::path& folder, const LastJob& now) {
    const std::string job = number_of("SLURM_JOB_ID");
    // A job that Slurm restarted after its node died already has a substitute.
    if (now.attempt >= last_jobs_in_all || job.empty() || !number_of("SLURM_RESTART_COUNT").empty()) return;
    Words more = {"--dependency=afternotok:" + job, "--kill-on-invalid-dep=yes"};
    add_excluded(more, avoidable({number_of("SLURMD_NODENAME")}, usable_nodes(number_of("SLURM_JOB_PARTITION"))));
    Cluster cluster = cluster_of(folder);
    send_last(folder, cluster, {now.sent, now.attempt + 1}, more);
}

void send_again(const fs::path& folder, const ClassProgress& progress, const LastJob& now) {
    Cluster cluster = cluster_of(folder);
    const auto usable = usable_nodes(number_of("SLURM_JOB_PARTITION"));
    const auto queue = queued_jobs().value_or(std::vector<QueuedJob>{});
    std::map<std::set<std::string>, std::vector<int>> parts_by_avoided;
    for (int part = 1; part <= cluster.parts; ++part) {
        bool lacks = false;
        for (size_t i = size_t(part - 1); i < progress.marks.size(); i += size_t(cluster.parts))
            lacks = lacks || !progress.marks[i];
        if (!lacks) continue;
        Words nodes = nodes_of(folder, part);
        // Slurm knows the node even if the job failed before it could write the node's name.
        if (const QueuedJob* const job = find_job(queue, cluster, part); job && !job->node.empty())
            nodes.insert(nodes.begin(), job->node);
        parts_by_avoided[avoidable(nodes, usable)].push_back(part);
    }
    Words jobs;
    for (const auto& [nodes, parts] : parts_by_avoided) {
        send_parts(folder, cluster, parts, nodes);
        jobs.push_back(cluster.sent.back().job);
    }
    send_last(folder, cluster, {now.sent + 1, 1}, {after(jobs)});
}

void note_end(const fs::path& folder) {
    Cluster cluster = cluster_of(folder);
    cluster.has_ended = true;
    write_cluster(folder, cluster);
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
        if (const Words nodes = nodes_of(folder, part); !nodes.empty()) state.node = nodes.front();
        set_state(state, find_job(jobs, cluster, part), queue.has_value(),
                  place(folder) / fmt::format("part-{}.log", part));
        states.push_back(std::move(state));
    }
    PartState last;
    set_state(last, find_job(jobs, cluster, 0), queue.has_value(), place(folder) / "last.log");
    if (cluster.has_ended) last.state = "done", last.reason.clear();
    states.push_back(std::move(last));
    return states;
}

}  // namespace relief::grade
