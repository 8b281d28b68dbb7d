// Shows which submissions of a class share code that the starter does not have, task by task. It never says who copied:
// a person reads both texts and decides.
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "framework/core/lab/registry.h"
#include "framework/staff/class/class_file.h"

namespace relief::grade {

/// A submission whose code is compared.
struct Author {
    std::string name;                          ///< printable; several submissions of one name have their paths
    std::string team = {};                     ///< two members of a team are no pair; empty: none
    bool is_earlier = false;                   ///< from an earlier class: compared with this one's only
    std::map<std::string, std::string> files;  ///< the text of task files, by their paths in the course
    std::vector<std::string> problems;         ///< why it, or a file of it, is not compared
};

/// A range of a file that the other submission has, too.
struct SharedRange {
    size_t begin, end;
    bool is_rare;  ///< at most `usual_count` of the other submissions and known solutions have it
};
/// One submission's half of a pair.
struct SharedSide {
    double share = 0;                               ///< of its own fingerprints, how many the other one has
    std::vector<std::pair<int, int>> lines;         ///< first and last lines of the shared ranges, counted from 1
    std::vector<SharedRange> ranges;                ///< in the text's order
    std::vector<std::pair<size_t, size_t>> pieces;  ///< the task's definitions, as ranges of the file
};
/// Code of one task that two submissions share.
struct SharedTask {
    std::string task, file;
    double bits = 0;    ///< how much better "one knew the other's text" explains it than "each wrote alone"
    size_t shared = 0;  ///< fingerprints that both have
    size_t rare = 0;    ///< of these, how many at most `usual_count` others have
    std::array<SharedSide, 2> sides;
};
struct SimilarPair {
    std::array<size_t, 2> authors{};  ///< indices of OriginalityReport::authors; the first is of this class
    double bits = 0;                  ///< sum over the tasks of the bits beyond task_toll_bits
    double by_chance = 0;             ///< expected number of such pairs in a class of independent authors
    int cluster = 0;                  ///< counted from 1
    std::vector<SharedTask> tasks;    ///< by surprise, largest first
};

struct ComparedTask {
    std::string id, title;
    size_t texts = 0;           ///< submissions with code of their own
    size_t known = 0;           ///< the solution and its correct variants
    size_t own_tokens = 0;      ///< median number of tokens that the starter does not have
    bool is_too_short = false;  ///< a copy of the median text would not be listed
};

struct OriginalityReport {
    std::vector<Author> authors;
    std::vector<ComparedTask> tasks;
    std::vector<SimilarPair> pairs;             ///< at least `alarm_bits`, by surprise, largest first
    std::vector<std::vector<size_t>> clusters;  ///< authors connected by pairs; cluster n is at n - 1
    size_t compared = 0;                        ///< number of pairs of submissions
    size_t of_teams = 0;                        ///< of these, how many are of one team and not listed
    double alarm_bits = 0;                      ///< a pair with fewer is not listed
    double below_alarm_bits = 0;                ///< the most surprising pair that is not listed
    size_t usual_count = 0;                     ///< code that more of the others have is not rare
    double seconds = 0;
};

/// Bits of a task that do not count, so that a sum over many tasks does not become large by chance.
constexpr double task_toll_bits = 5;
/// Expected number of listed pairs in a class of independent authors, as far as the model of them is right.
constexpr double alarm_by_chance = 0.001;

/// Which fingerprints of one text another text has, too.
using Having = std::vector<bool>;

/// Returns the bits by which "B knew A's text" explains the shared fingerprints better than "B wrote alone".
/// `weights[i]`: how much of an independent event fingerprint i of A is, in (0, 1]. `b`: the fingerprints that B
/// has. `others`: the fingerprints of other submissions and known solutions. README.md explains the model.
double bits_of_copy(const std::vector<double>& weights, const Having& b, const std::vector<const Having*>& others);

/// Reads and compares the submissions at `paths`, and the earlier ones: each entry of a folder in `earlier` is a
/// submission. `policy` has the roster with its teams. `labs` empty: all labs. Throws UsageError if there are fewer
/// than two submissions to compare, and for a folder in `earlier` that is none or empty. Never throws because of a
/// submission's content.
OriginalityReport compare_class(const std::vector<std::filesystem::path>& paths,
                                const std::vector<std::filesystem::path>& earlier,
                                const std::vector<const LabEntry*>& labs, const ClassFile& policy = {});

/// Returns the lines as text: "12-15, 20".
std::string lines_of(const SharedSide& side);
/// Returns an expected number for people: "0.003", "1 in 10^7".
std::string by_chance(double expected);
/// Returns the listed pairs: one line for each pair and task.
std::string originality_csv(const OriginalityReport& report);
/// Returns the whole report but the texts, schema 1.
std::string originality_json(const OriginalityReport& report);
/// Returns a short table for a terminal.
std::string originality_table(const OriginalityReport& report);

}  // namespace relief::grade
