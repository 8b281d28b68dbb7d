#include "framework/staff/cluster/cluster.h"

#include <fmt/format.h>

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

std::optional<Words> jobs_at_work(const Cluster& cluster) {
    const auto queued = queued_jobs();
    if (!queued) return {};
    Words jobs = {cluster.parts_job, cluster.report_job};
    std::erase_if(jobs, [&](const std::string& job) { return !queued->contains(job); });
    return jobs;
}

std::string last_message(const fs::path& folder, int part) {
    const fs::path log = place(folder) / (part == 0 ? "last.log" : fmt::format("part-{}.log", part));
    std::string said;
    if (std::error_code unknown; fs::exists(log, unknown))
        for (const std::string& line : split(read_file(log), '\n'))
            if (line.starts_with("relief: ") || line.starts_with("slurmstepd: "))
                said = line.substr(line.find(' ') + 1);
    return printable(said);
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

}  // namespace relief::grade
