// Slurm, through its commands: sbatch and squeue.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace relief::grade {

/// Returns whether `sbatch` is on PATH.
bool has_slurm();

/// Returns the number of processors of this process's Slurm job (SLURM_CPUS_PER_TASK, else SLURM_CPUS_ON_NODE); nothing
/// outside of a job. Throws UsageError for anything but a number from 1 on.
std::optional<int> processors_from_slurm();

/// Submits a job and returns its number. `options` and `script` are sbatch's arguments; sbatch also takes options from
/// the environment (SBATCH_PARTITION and so on). The job inherits this process's environment without RELIEF_SEED, and
/// not its resource limits. Throws Error with sbatch's message.
std::string submit_job(const std::vector<std::string>& options, const std::vector<std::string>& script);

/// A job, or a task of an array, as squeue knows it. Slurm forgets an ended job after some minutes.
struct QueuedJob {
    std::string job;          ///< number; for a task, the number of its array
    std::optional<int> task;  ///< index in its array
    std::string state;        ///< "PENDING", "RUNNING", "COMPLETED", "FAILED", "NODE_FAIL" ...
    std::string node;         ///< where it runs or ran; empty while it waits
    std::string reason;       ///< why it waits

    bool waits() const;
    bool runs() const;
    bool has_ended() const { return !waits() && !runs(); }
};
/// Returns this user's jobs; nothing if squeue fails.
std::optional<std::vector<QueuedJob>> queued_jobs();

}  // namespace relief::grade
