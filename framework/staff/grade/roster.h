// class.json: who is in a class and how it is graded. Every run into its folder and every shard of it agree on that.
#pragma once

#include <filesystem>
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
    std::string course;             ///< hash of all that a mark depends on beside the submission; the seed is in it
    std::string seed;               ///< of the hidden views, or empty
    std::vector<std::string> labs;  ///< folders; none: those that each submission has a file of
    std::vector<One> submissions;   ///< in the order in which they were named
};

std::string to_json(const Roster& roster);
/// In `folder`; nothing when it is not there. Throws Error when it is not that.
std::optional<Roster> read_roster(const std::filesystem::path& folder);
void write_roster(const std::filesystem::path& folder, const Roster& roster);

/// The `index`-th of `count` parts of a class, from 0: every count-th submission.
struct Shard {
    int index = 0, count = 1;
    std::string from = {};  ///< what says so
    bool whole() const { return count == 1; }
};

/// "2/8" is the second of eight. When `text` is empty the environment decides: a task of a Slurm array
/// (SLURM_ARRAY_TASK_ID with _MIN, _STEP and _COUNT), TEST_SHARD_INDEX with TEST_TOTAL_SHARDS, or GTEST_SHARD_INDEX
/// with GTEST_TOTAL_SHARDS. Throws UsageError for what is neither.
Shard shard_of(const std::string& text);

}  // namespace relief
