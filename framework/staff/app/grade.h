// What the ways to grade a class have in common: on this machine, and on a cluster by Slurm.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "framework/staff/grade/class.h"
#include "framework/staff/grade/cluster.h"
#include "framework/staff/grade/standing.h"

namespace relief {

/// The table of marks. Returns the exit code: 1 if a submission has no mark.
int print_report(const ClassReport& report, const ClassStanding& standing, const std::filesystem::path& folder,
                 const Shard& shard);

/// Writes a submission's pages. A result is written after its pages, so a run that is killed leaves none without.
SubmissionDone pages_into(const std::filesystem::path& folder);

/// Throws Error that says how to grade `parts` parts by hand if there is no Slurm here.
void require_slurm(int parts);

/// Writes class.json and sends the class to Slurm; `processors` for each part, 0 for what Slurm gives. Throws Error if
/// jobs of an earlier start are still at work.
int start_class(const ClassOptions& options, int parts, int processors, const std::vector<std::string>& words);

/// In the last job: sends parts again, or grades those that lack a result and writes the report.
int end_class(const ClassOptions& options, const LastJob& now);

/// How far the class in `folder` is, for a person or a script.
int print_status(const std::filesystem::path& folder, bool json);

}  // namespace relief
