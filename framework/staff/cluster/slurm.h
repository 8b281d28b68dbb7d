// Slurm, through its commands: sbatch and squeue.
#pragma once

#include <optional>
#include <set>
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

/// Returns the numbers of this user's jobs that wait or run; for a task, the number of its array. Nothing if squeue
/// fails.
std::optional<std::set<std::string>> queued_jobs();

}  // namespace relief::grade
