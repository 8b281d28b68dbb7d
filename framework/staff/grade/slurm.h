// Slurm, through its commands: sbatch, squeue, sinfo.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace relief {

/// Whether there is an `sbatch` on PATH.
bool has_slurm();

/// The processors that Slurm gave the job that this process runs in (SLURM_CPUS_PER_TASK, else SLURM_CPUS_ON_NODE);
/// nothing outside of a job. Throws UsageError for anything but a number from 1 on.
std::optional<int> processors_from_slurm();

/// Submits a job and returns its number. `options` and `script` are sbatch's words; its options also come from the
/// environment (SBATCH_PARTITION and so on). The job gets this process's environment without RELIEF_SEED, and not its
/// limits. Throws Error with what sbatch says.
std::string submit_job(const std::vector<std::string>& options, const std::vector<std::string>& script);

/// A job, or a task of an array, as squeue knows it. Slurm forgets an ended job after some minutes.
struct QueuedJob {
    std::string job;          ///< of an array: the array's
    std::optional<int> task;  ///< of an array
    std::string state;        ///< "PENDING", "RUNNING", "COMPLETED", "FAILED", "NODE_FAIL" ...
    std::string node;         ///< where it runs or ran; empty while it waits
    std::string reason;       ///< why it waits

    bool waits() const;
    bool runs() const;
    bool has_ended() const { return !waits() && !runs(); }
};
/// This user's jobs; nothing if squeue does not answer.
std::optional<std::vector<QueuedJob>> queued_jobs();

/// The nodes of a partition (empty: of all) that can run jobs now or later without anybody's help; nothing if sinfo
/// does not answer.
std::optional<std::set<std::string>> usable_nodes(const std::string& partition);

}  // namespace relief
