// Shared by both ways to grade a class: on this machine, and on a cluster with Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/staff/class/class.h"
#include "framework/staff/class/record.h"
#include "framework/staff/cluster/cluster.h"

namespace relief::app {

/// Prints the table of marks. Returns the exit code: 1 if a submission has no mark.
int print_report(const grade::ClassReport& report, const grade::ClassRecord& record,
                 const std::filesystem::path& folder, const grade::Shard& shard);

/// Returns a callback that writes a submission's pages. It runs before the result is written, so every result of a
/// killed run has its pages.
grade::SubmissionDone pages_into(const std::filesystem::path& folder);

/// If there is no Slurm here, throws Error that explains how to grade `parts` parts by hand.
void require_slurm(int parts);

/// Writes class.json and sends the class to Slurm. `processors` is the number for each part, 0 for Slurm's default.
/// Throws Error if jobs of an earlier start are still running.
int start_class(const grade::ClassOptions& options, int parts, int processors, const std::vector<std::string>& words);

/// Prints the progress of the class in `folder`, for a person or, as JSON, for a script.
int print_status(const std::filesystem::path& folder, bool json);

}  // namespace relief::app
