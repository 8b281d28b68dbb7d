// The report on shared code as CSV, as JSON and as a table for a terminal.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/core/base/text.h"
#include "framework/staff/class/csv.h"
#include "framework/staff/originality/originality.h"

namespace relief::grade {
namespace {

using nlohmann::ordered_json;

/// Number of pairs and clusters in the terminal's table.
constexpr size_t shown_rows = 20;

std::string percent(double share) { return fmt::format("{:.0f} %", 100 * share); }

ordered_json json_of(const SharedSide& side) {
    ordered_json lines = ordered_json::array();
    for (const auto& [first, last] : side.lines) lines.push_back({first, last});
    return {{"share", side.share}, {"lines", lines}};
}

}  // namespace

std::string lines_of(const SharedSide& side) {
    std::vector<std::string> ranges;
    for (const auto& [first, last] : side.lines)
        ranges.push_back(first == last ? fmt::format("{}", first) : fmt::format("{}-{}", first, last));
    return join(ranges, ", ");
}

std::string by_chance(double expected) {
    if (expected >= 0.0001) return rounded(expected, 1);
    if (expected < 1e-12) return "below 1 in 10^12";
    return fmt::format("1 in 10^{:.0f}", std::floor(-std::log10(expected)));
}

std::string originality_csv(const OriginalityReport& report) {
    const std::string columns[] = {"cluster",
                                   "submission",
                                   "other",
                                   "bits",
                                   "expected by chance",
                                   "task",
                                   "task bits",
                                   "shared",
                                   "rare",
                                   "share of submission",
                                   "share of other",
                                   "file",
                                   "lines of submission",
                                   "lines of other"};
    std::string text = csv_line(columns);
    for (const SimilarPair& pair : report.pairs)
        for (const SharedTask& task : pair.tasks) {
            const std::string cells[] = {std::to_string(pair.cluster),
                                         defused(report.authors[pair.authors[0]].name),
                                         defused(report.authors[pair.authors[1]].name),
                                         fmt::format("{:.1f}", pair.bits),
                                         fmt::format("{:.1e}", pair.by_chance),
                                         task.task,
                                         fmt::format("{:.1f}", task.bits),
                                         std::to_string(task.shared),
                                         std::to_string(task.rare),
                                         fmt::format("{:.2f}", task.sides[0].share),
                                         fmt::format("{:.2f}", task.sides[1].share),
                                         task.file,
                                         lines_of(task.sides[0]),
                                         lines_of(task.sides[1])};
            text += csv_line(cells);
        }
    return text;
}

std::string originality_json(const OriginalityReport& report) {
    ordered_json all = {{"schema", 1},
                        {"alarm_bits", report.alarm_bits},
                        {"below_alarm_bits", report.below_alarm_bits},
                        {"pairs_compared", report.compared},
                        {"usual_count", report.usual_count},
                        {"seconds", report.seconds}};
    const auto name = [&](size_t author) { return report.authors[author].name; };
    for (const char* list : {"pairs", "clusters", "tasks", "submissions"}) all[list] = ordered_json::array();
    for (const SimilarPair& pair : report.pairs) {
        ordered_json one = {{"submissions", {name(pair.authors[0]), name(pair.authors[1])}},
                            {"bits", pair.bits},
                            {"expected_by_chance", pair.by_chance},
                            {"cluster", pair.cluster},
                            {"tasks", ordered_json::array()}};
        for (const SharedTask& task : pair.tasks)
            one["tasks"].push_back({{"task", task.task},
                                    {"file", task.file},
                                    {"bits", task.bits},
                                    {"shared", task.shared},
                                    {"rare", task.rare},
                                    {"sides", {json_of(task.sides[0]), json_of(task.sides[1])}}});
        all["pairs"].push_back(std::move(one));
    }
    for (const std::vector<size_t>& cluster : report.clusters) {
        ordered_json names = ordered_json::array();
        for (const size_t author : cluster) names.push_back(name(author));
        all["clusters"].push_back(std::move(names));
    }
    for (const ComparedTask& task : report.tasks)
        all["tasks"].push_back({{"task", task.id},
                                {"submissions", task.texts},
                                {"known_solutions", task.known},
                                {"own_tokens", task.own_tokens},
                                {"too_short", task.is_too_short}});
    for (const Author& author : report.authors)
        all["submissions"].push_back(
            {{"name", author.name}, {"earlier", author.is_earlier}, {"problems", author.problems}});
    return all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string originality_table(const OriginalityReport& report) {
    std::string text;
    const auto name = [&](size_t author) -> const std::string& { return report.authors[author].name; };
    size_t widest = 10;
    for (const SimilarPair& pair : report.pairs)
        for (const size_t author : pair.authors) widest = std::max(widest, name(author).size());
    widest = std::min<size_t>(widest, 32);
    if (!report.pairs.empty())
        text += fmt::format("{:<{}}  {:<{}}  {:>6}  {:>16}  tasks (rare of shared fingerprints, share of each)\n",
                            "look at", widest, "beside", widest, "bits", "by chance");
    for (size_t i = 0; i < std::min(report.pairs.size(), shown_rows); ++i) {
        const SimilarPair& pair = report.pairs[i];
        std::vector<std::string> tasks;
        for (const SharedTask& task : pair.tasks) {
            if (tasks.size() == 3) {
                tasks.push_back(fmt::format("{} more", pair.tasks.size() - 3));
                break;
            }
            tasks.push_back(fmt::format("{} ({} of {}, {} and {})", task.task, task.rare, task.shared,
                                        percent(task.sides[0].share), percent(task.sides[1].share)));
        }
        text += fmt::format("{:<{}}  {:<{}}  {:>6.1f}  {:>16}  {}\n", name(pair.authors[0]), widest,
                            name(pair.authors[1]), widest, pair.bits, by_chance(pair.by_chance), join(tasks, ", "));
    }
    if (report.pairs.size() > shown_rows) text += fmt::format("and {} more pairs\n", report.pairs.size() - shown_rows);
    for (size_t i = 0; i < std::min(report.clusters.size(), shown_rows); ++i) {
        if (report.clusters[i].size() < 3) continue;
        std::vector<std::string> names;
        for (const size_t author : report.clusters[i]) names.push_back(name(author));
        text += fmt::format("cluster {}: {}\n", i + 1, join(names, ", "));
    }
    std::vector<std::string> too_short;
    for (const ComparedTask& task : report.tasks)
        if (task.is_too_short) too_short.push_back(task.id);
    if (!too_short.empty()) text += "too short to tell anything alone: " + join(too_short, ", ") + "\n";
    return text;
}

}  // namespace relief::grade
