// class.json: the submissions of a class, and how they are graded. All runs into its folder and all its shards agree on
// it.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace relief {

struct Roster {
    struct One {
        std::string name, hash;      ///< of the submission
        std::filesystem::path path;  ///< absolute
        bool operator==(const One&) const = default;
    };
    std::string course;             ///< hash of everything but the submission that decides a mark, seed included
    std::string seed;               ///< of the hidden views, or empty
    std::vector<std::string> labs;  ///< folders; empty: for each submission the labs whose files it has
    std::vector<One> submissions;   ///< in the order of the command line
    /// Seconds of processor time that a lab's solution took, by folder: measured once, where the class was started.
    std::map<std::string, double> solution_cpu = {};
};

std::string to_json(const Roster& roster);
/// Reads class.json in `folder`; nothing if there is none. Throws Error if the file is not a roster.
std::optional<Roster> read_roster(const std::filesystem::path& folder);
/// For its owner alone to read: it has the seed.
void write_roster(const std::filesystem::path& folder, const Roster& roster);
/// Adds what was `measured` to the class.json in `folder`, where it has no figure of a lab yet; returns all its
/// figures. Parts of a class may do so at a time: the first one's figure stands.
std::map<std::string, double> add_solution_cpu(const std::filesystem::path& folder,
                                               const std::map<std::string, double>& measured);

/// One of `count` parts of a class: every count-th submission, from `index` on. `index` counts from 0.
struct Shard {
    int index = 0, count = 1;
    std::string from = {};  ///< the option or the variable that chose it
    bool whole() const { return count == 1; }
};

/// "2/8" is the second of eight parts. If `text` is empty, the environment decides: a task of a Slurm array
/// (SLURM_ARRAY_TASK_ID with _MIN, _MAX, _STEP and _COUNT; all of a row of numbers), TEST_SHARD_INDEX with
/// TEST_TOTAL_SHARDS, or GTEST_SHARD_INDEX with GTEST_TOTAL_SHARDS; without those it is the whole class. Throws
/// UsageError for any other text or value.
Shard shard_of(const std::string& text);

}  // namespace relief
