// Grades a class with Slurm: sends the jobs, and reads the files that they leave in FOLDER/slurm.
//
// An array of jobs grades the parts of the class, each part by `relief grade --resume --shard`. When all have ended, a
// last job sends parts without results again, or writes the report. The results that exist are the only state that
// decides.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/staff/class/progress.h"

namespace relief::grade {

/// How often parts that lack results are sent again, away from the nodes on which they failed.
constexpr int times_sent_again = 3;

/// The content of FOLDER/slurm/cluster.json.
struct Cluster {
    struct Sent {
        std::string job;
        bool is_last = false;  ///< true: the job that ends the class, not an array of parts
    };
    int parts = 1;
    std::vector<std::string> options;  ///< sbatch's options for each job
    std::vector<Sent> sent;            ///< in the order of submission
    bool has_ended = false;            ///< the report is written
};

/// Reads cluster.json. Returns nothing if the class in `folder` was never sent to Slurm. Throws Error if the file is
/// damaged.
std::optional<Cluster> read_cluster(const std::filesystem::path& folder);

/// Returns the jobs of the class that wait or run, according to Slurm.
std::vector<std::string> jobs_at_work(const Cluster& cluster);

/// Writes the jobs' scripts into FOLDER/slurm, where they replace scripts of an earlier run. Then sends all parts and
/// the last job. `folder` contains class.json; `options` are options of `relief grade`. Throws Error if Slurm rejects a
/// job.
Cluster send_class(const std::filesystem::path& folder, int parts, int jobs_at_a_time,
                   const std::vector<std::string>& options);

/// Counters that each last job receives from its sender.
struct LastJob {
    int sent = 1;     ///< how often parts have been sent
    int attempt = 1;  ///< number of last jobs since then, this one included
};
/// Returns the counters of this last job; nothing in any other process.
std::optional<LastJob> this_last_job();

/// Sends a substitute that takes over if this last job fails, on another node if there is one. There are at most three
/// last jobs in all. Throws Error if Slurm rejects the job.
void send_substitute(const std::filesystem::path& folder, const LastJob& now);

/// Sends the parts without results again, and a last job for them. Each part avoids its earlier nodes while other nodes
/// are usable. Throws Error if Slurm rejects a job.
void send_again(const std::filesystem::path& folder, const ClassProgress& progress, const LastJob& now);

void note_end(const std::filesystem::path& folder);

/// A part of the class, or the last job.
struct PartState {
    int part = 0;  ///< counts from 1; 0: the last job
    size_t submissions = 0, results = 0;
    std::string state;   ///< "done", "runs", "waits", "failed", "unknown"
    std::string node;    ///< where it runs or ran; may be empty
    std::string job;     ///< "12_3"; may be empty
    std::string reason;  ///< why it waits or failed; may be empty
};
/// Returns the states of all parts, and then of the last job.
std::vector<PartState> part_states(const std::filesystem::path& folder, const Cluster& cluster,
                                   const ClassProgress& progress);

}  // namespace relief::grade
