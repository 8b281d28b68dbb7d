// A class that Slurm grades: the jobs that are sent, and what they leave in FOLDER/slurm.
//
// An array of jobs grades the class's parts, each part by `relief grade --resume --shard`. When all have ended, a last
// job sends the parts again that lack results, or writes the report. All that decides is which results are there.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "framework/staff/grade/progress.h"

namespace relief {

/// Parts that lack results are sent again so often, away from the nodes on which they were.
constexpr int times_sent_again = 3;

/// FOLDER/slurm/cluster.json
struct Cluster {
    struct Sent {
        std::string job;
        bool is_last = false;  ///< the job that ends the class, not parts of it
    };
    int parts = 1;
    std::vector<std::string> options;  ///< for sbatch, of each job
    std::vector<Sent> sent;            ///< in this order
    bool has_ended = false;            ///< the report is written
};

/// Nothing if the class in `folder` was never sent to Slurm. Throws Error if the file is damaged.
std::optional<Cluster> read_cluster(const std::filesystem::path& folder);

/// Which jobs of the class still wait or run, as Slurm knows.
std::vector<std::string> jobs_at_work(const Cluster& cluster);

/// Writes the jobs' scripts into FOLDER/slurm, in place of those of an earlier run, and sends all parts and the last
/// job. class.json is in `folder`; `options` are those of `relief grade`. Throws Error if Slurm takes no job.
Cluster send_class(const std::filesystem::path& folder, int parts, int jobs_at_a_time,
                   const std::vector<std::string>& options);

/// What a last job was told by the one that sent it.
struct LastJob {
    int sent = 1;     ///< how often parts have been sent
    int attempt = 1;  ///< how many last jobs there have been since
};
/// Nothing outside of a last job.
std::optional<LastJob> this_last_job();

/// Sends a job that does this last job's work, on another node if there is one, should this one fail: at most three in
/// all. Throws Error if Slurm takes no job.
void send_substitute(const std::filesystem::path& folder, const LastJob& now);

/// Sends the parts that lack results, each away from the nodes on which it was as long as there are others, and a last
/// job for them. Throws Error if Slurm takes no job.
void send_again(const std::filesystem::path& folder, const ClassProgress& progress, const LastJob& now);

void note_end(const std::filesystem::path& folder);

/// A part of the class, or the last job.
struct PartState {
    int part = 0;  ///< from 1 on; 0: the last job
    size_t submissions = 0, results = 0;
    std::string state;   ///< "done", "runs", "waits", "failed", "unknown"
    std::string node;    ///< where it runs or was; may be empty
    std::string job;     ///< "12_3"; may be empty
    std::string reason;  ///< why it waits or failed; may be empty
};
/// The last job comes last.
std::vector<PartState> part_states(const std::filesystem::path& folder, const Cluster& cluster,
                                   const ClassProgress& progress);

}  // namespace relief
