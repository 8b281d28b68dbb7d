// Grades a class with Slurm: submits the jobs, and reads the files that they leave in FOLDER/slurm.
//
// An array of jobs grades the parts of the class, each by `relief grade --resume --shard`. When all have ended, a last
// job runs `relief grade --resume`: it grades what has no result, and writes the report. Slurm runs the jobs of a dead
// node again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace relief::grade {

/// The content of FOLDER/slurm/cluster.json.
struct Cluster {
    int parts = 1;
    std::string parts_job, report_job;  ///< Slurm's numbers of the array and of the job that ends the class
    bool has_report = false;            ///< the report is newer than the jobs; not in the file
};

/// Reads cluster.json. Returns nothing if the class in `folder` was never sent to Slurm. Throws Error if the file is
/// damaged.
std::optional<Cluster> read_cluster(const std::filesystem::path& folder);

/// Returns the jobs of the class that wait or run. Nothing if squeue fails.
std::optional<std::vector<std::string>> jobs_at_work(const Cluster& cluster);

/// Writes the jobs' scripts into FOLDER/slurm, where they replace scripts of an earlier run. Then submits all parts and
/// the last job. `folder` contains class.json; `options` are options of `relief grade`. Throws Error if Slurm rejects a
/// job.
Cluster send_class(const std::filesystem::path& folder, int parts, int jobs_at_a_time,
                   const std::vector<std::string>& options);

/// Returns the last message of a part's grader, or of the last job's (part 0), from its log. Empty if it has none.
std::string last_message(const std::filesystem::path& folder, int part);

}  // namespace relief::grade
