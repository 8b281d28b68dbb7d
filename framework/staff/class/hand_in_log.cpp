#include "framework/staff/class/hand_in_log.h"

#include <fmt/format.h>

#include <algorithm>

#include "framework/core/base/file.h"
#include "framework/staff/class/csv.h"

namespace relief::grade {
namespace {

namespace fs = std::filesystem;

using LogCells = std::vector<std::string>;

const LogCells log_columns{"lab", "graded_at", "files"};

fs::path log_file(const fs::path& folder, const std::string& name, const char* ending) {
    return folder / "hand_ins" / (file_name_of(name) + ending);
}

std::chrono::sys_days local_day(Moment moment, UtcOffset offset) {
    return std::chrono::floor<std::chrono::days>(moment + offset);
}

}  // namespace

std::vector<GradedHandIn> read_hand_in_log(const fs::path& folder, const std::string& name) {
    const fs::path file = log_file(folder, name, ".csv");
    if (!fs::exists(file)) return {};
    const CsvTable table = read_csv(file);
    table.refuse_columns(log_columns, log_columns);
    std::vector<GradedHandIn> log;
    for (const CsvRow& row : table.rows)
        log.push_back({table.cell(row, "lab"), parse_moment(table.cell(row, "graded_at"), {}, {file, row.line}),
                       table.cell(row, "files")});
    return log;
}

void log_hand_ins(const fs::path& folder, const std::string& name, const std::vector<GradedHandIn>& more,
                  UtcOffset offset) {
    if (more.empty()) return;
    const fs::path file = log_file(folder, name, ".csv");
    std::string text = fs::exists(file) ? read_file(file) : csv_line(log_columns);
    if (!text.ends_with('\n')) text += '\n';  // a person may have edited it
    for (const GradedHandIn& one : more)
        text += csv_line(LogCells{one.lab, moment_text(one.graded_at, offset), one.files});
    make_folder(file.parent_path());
    write_file_to_disk(file, text);
}

const GradedHandIn* last_hand_in(const std::vector<GradedHandIn>& log, const std::string& lab) {
    const auto last = std::find_if(log.rbegin(), log.rend(), [&](const GradedHandIn& one) { return one.lab == lab; });
    return last == log.rend() ? nullptr : &*last;
}

int hand_ins_on_day(const std::vector<GradedHandIn>& log, const std::string& lab, Moment moment, UtcOffset offset) {
    return int(std::count_if(log.begin(), log.end(), [&](const GradedHandIn& one) {
        return one.lab == lab && local_day(one.graded_at, offset) == local_day(moment, offset);
    }));
}

std::optional<SubmissionMark> earlier_marks(const fs::path& folder, const std::string& name,
                                            const std::string& course) {
    const fs::path file = log_file(folder, name, ".json");
    if (!fs::exists(file)) return {};
    try {
        SubmissionMark mark = from_json(read_file(file, size_t{1} << 26));
        if (mark.name == name && mark.course == course) return mark;
    } catch (const Error&) {  // damaged, or of another version: the hand-in is graded
    }
    return {};
}

void keep_marks(const fs::path& folder, const SubmissionMark& mark) {
    SubmissionMark kept = mark;
    std::erase_if(kept.labs, [](const LabMark& lab) { return !lab.graded(); });
    for (LabMark& lab : kept.labs) lab.kept.clear();
    if (const auto before = earlier_marks(folder, mark.name, mark.course))
        for (const LabMark& lab : before->labs)
            if (!kept.lab(lab.lab)) kept.labs.push_back(lab);
    const fs::path file = log_file(folder, mark.name, ".json");
    make_folder(file.parent_path());
    write_file_to_disk(file, to_json(kept));
}

}  // namespace relief::grade
