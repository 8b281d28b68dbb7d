#include "framework/staff/pages/originality_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/file.h"
#include "framework/course/pages/page.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::pages {
namespace {

/// Returns the pieces of a file as lines with numbers. Shared ranges are marked.
List code_rows(const grade::SharedSide& side, const std::string& file) {
    List rows;
    for (const auto& [piece_begin, piece_end] : side.pieces) {
        const size_t line_begin = piece_begin == 0 ? 0 : file.rfind('\n', piece_begin - 1) + 1;
        size_t number = 1 + size_t(std::count(file.begin(), file.begin() + std::ptrdiff_t(line_begin), '\n'));
        for (size_t at = line_begin; at < piece_end; ++number) {
            const size_t end = std::min(file.find('\n', at), file.size());
            List parts;
            const size_t first = std::min(file.find_first_not_of(" \t", at), end);  // indentation is not marked
            const auto add = [&](size_t begin, size_t stop, const char* kind) {
                if (begin >= stop) return;
                const std::string text = file.substr(begin, stop - begin);
                parts.push_back(Fields{{"text", grade::printable_lines(text, text.size())}, {"kind", kind}});
            };
            size_t done = at;
            for (const grade::SharedRange& range : side.ranges) {
                if (range.end <= at || range.begin >= end) continue;
                const size_t begin = std::max(range.begin, first);
                add(done, begin, "");
                add(begin, std::min(range.end, end), range.is_rare ? "rare" : "usual");
                done = std::min(range.end, end);
            }
            add(done, end, "");
            rows.push_back(Fields{{"number", number}, {"parts", std::move(parts)}});
            at = end + 1;
        }
    }
    return rows;
}

Fields side_fields(const grade::OriginalityReport& report, size_t author, const grade::SharedTask& task, size_t side) {
    const grade::Author& one = report.authors[author];
    return {{"name", one.name},
            {"share", fmt::format("{:.0f}", 100 * task.sides[side].share)},
            {"lines", grade::lines_of(task.sides[side])},
            {"rows", code_rows(task.sides[side], one.files.at(task.file))}};
}

Value pairs_of(const grade::OriginalityReport& report) {
    List pairs;
    for (size_t i = 0; i < std::min(report.pairs.size(), pairs_on_page); ++i) {
        const grade::SimilarPair& pair = report.pairs[i];
        List tasks;
        for (const grade::SharedTask& task : pair.tasks) {
            const auto info = std::find_if(report.tasks.begin(), report.tasks.end(),
                                           [&](const grade::ComparedTask& one) { return one.id == task.task; });
            tasks.push_back(Fields{{"id", task.task},
                                   {"title", info->title},
                                   {"is_first", tasks.empty()},
                                   {"bits", fmt::format("{:.0f}", task.bits)},
                                   {"shared", task.shared},
                                   {"rare", fmt::format("{}", task.rare)},
                                   {"file", task.file},
                                   {"sides", List{side_fields(report, pair.authors[0], task, 0),
                                                  side_fields(report, pair.authors[1], task, 1)}}});
        }
        pairs.push_back(Fields{{"number", i + 1},
                               {"first", report.authors[pair.authors[0]].name},
                               {"second", report.authors[pair.authors[1]].name},
                               {"earlier", report.authors[pair.authors[1]].is_earlier},
                               {"bits", fmt::format("{:.0f}", pair.bits)},
                               {"by_chance", grade::by_chance(pair.by_chance)},
                               {"cluster", pair.cluster},
                               {"tasks", std::move(tasks)}});
    }
    return rows(std::move(pairs));
}

Value clusters_of(const grade::OriginalityReport& report) {
    List clusters;
    for (size_t i = 0; i < report.clusters.size(); ++i) {
        List names;
        for (const size_t author : report.clusters[i])
            names.push_back(Fields{{"name", report.authors[author].name}, {"is_first", names.empty()}});
        clusters.push_back(Fields{{"number", i + 1}, {"names", std::move(names)}});
    }
    return rows(std::move(clusters));
}

}  // namespace

std::string originality_page(const grade::OriginalityReport& report) {
    List tasks, problems;
    for (const grade::ComparedTask& task : report.tasks)
        tasks.push_back(Fields{{"id", task.id},
                               {"title", task.title},
                               {"texts", fmt::format("{}", task.texts)},
                               {"known", fmt::format("{}", task.known)},
                               {"tokens", fmt::format("{}", task.own_tokens)},
                               {"too_short", task.is_too_short}});
    for (const grade::Author& author : report.authors)
        for (const std::string& problem : author.problems)
            problems.push_back(Fields{{"name", author.name}, {"problem", problem}});
    const size_t listed = report.pairs.size();
    return render({.title = "Relief: pairs to look at",
                   .body = "framework/staff/pages/originality",
                   .styles = {"framework/staff/pages/originality"},
                   .scripts = {}},
                  {{"compared", fmt::format("{}", report.compared)},
                   {"submissions", fmt::format("{}", report.authors.size())},
                   {"listed", fmt::format("{}", listed)},
                   {"alarm", fmt::format("{:.0f}", report.alarm_bits)},
                   {"below", fmt::format("{:.0f}", report.below_alarm_bits)},
                   {"usual", report.usual_count},
                   {"left_out", listed > pairs_on_page ? Value(listed - pairs_on_page) : Value()},
                   {"pairs", pairs_of(report)},
                   {"clusters", clusters_of(report)},
                   {"problems", rows(std::move(problems))},
                   {"tasks", rows(std::move(tasks))}});
}

void write_originality(const grade::OriginalityReport& report, const std::filesystem::path& folder) {
    write_private_file(folder / "originality.csv", grade::originality_csv(report));
    write_private_file(folder / "originality.json", grade::originality_json(report));
    write_private_file(folder / "originality.html", originality_page(report));
}

}  // namespace relief::pages
