// class.json: the submissions of a class, and the settings of grading, shared by all shards and later runs into its
// folder.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "framework/staff/grade/submission.h"

namespace relief::grade {

struct Roster {
    struct One {
        std::string name, hash;                 ///< of the submission
        std::vector<SubmissionPart> parts;      ///< with absolute paths
        std::vector<std::string> remarks = {};  ///< see HandIn

        bool operator==(const One&) const = default;
    };
    std::string course;             ///< hash of everything except the submission that decides a mark, including the
                                    ///< seed
    std::string seed;               ///< of the hidden views, or empty
    std::vector<std::string> labs;  ///< folders; empty: for each submission the labs whose files it has
    std::vector<One> submissions;   ///< in the order of the command line
    std::vector<std::filesystem::path> given = {};  ///< all paths of the command line, absolute
    /// Seconds of processor time of a lab's solution, by folder. Measured once, by the run that started the class.
    std::map<std::string, double> solution_cpu = {};
};

std::string to_json(const Roster& roster);
/// Reads class.json in `folder`; nothing if there is none. Throws Error if the file is not a roster.
std::optional<Roster> read_roster(const std::filesystem::path& folder);
/// Writes class.json so that only its owner can read it: it contains the seed.
void write_roster(const std::filesystem::path& folder, const Roster& roster);
/// Adds the labs of `measured` to class.json in `folder` if it lacks them; returns all times in it. Several parts of a
/// class may call this at a time: the first time of a lab is kept.
std::map<std::string, double> add_solution_cpu(const std::filesystem::path& folder,
                                               const std::map<std::string, double>& measured);

/// One of `count` parts of a class: every count-th submission, starting at `index`, which counts from 0.
struct Shard {
    int index = 0, count = 1;
    std::string from = {};  ///< the option or the environment variable that chose it
    bool whole() const { return count == 1; }
};

/// Parses "2/8", the second of eight parts. If `text` is empty, the environment decides: a task of a Slurm array
/// (SLURM_ARRAY_TASK_ID with _MIN, _MAX, _STEP and _COUNT; evenly spaced tasks), TEST_SHARD_INDEX with
/// TEST_TOTAL_SHARDS, or GTEST_SHARD_INDEX with GTEST_TOTAL_SHARDS. Without these variables the result is the whole
/// class. Throws UsageError for any other text or value.
Shard shard_of(const std::string& text);

}  // namespace relief::grade
