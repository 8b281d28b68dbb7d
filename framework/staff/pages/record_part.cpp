#include "framework/staff/pages/record_part.h"

#include <fmt/format.h>

#include "framework/core/base/text.h"
#include "framework/course/check/check.h"
#include "framework/course/check/verdict.h"
#include "framework/course/pages/template.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::pages {
namespace {

// A student's text cannot contain these marks: pages escape it.
constexpr std::string_view begin_mark = "<!--record-->", end_mark = "<!--/record-->";

/// Returns the reasons for the points of a lab, one sentence each.
List reasons(const grade::LabRecord& lab, grade::UtcOffset offset, PageFor reader) {
    List list;
    if (!lab.marked) list.push_back("not graded yet");
    if (lab.marked && !lab.handed_in) list.push_back("nothing handed in");
    if (lab.marked && lab.handed_in && (lab.adjusted() != lab.graded() || lab.days_late > lab.bank_days))
        list.push_back(check::points_text(lab.graded()) + " by the checks");
    if (lab.adjusted() != lab.graded()) list.push_back(check::points_text(lab.adjusted()) + " with adjustments");
    if (lab.days_late > lab.bank_days)
        list.push_back(fmt::format("{} late: {}{} % less, {} of {}", amount_of(lab.days_late, "day"),
                                   lab.bank_days > 0 ? amount_of(lab.bank_days, "day") + " at no cost, " : "",
                                   rounded(100 * (1 - lab.late_share)), check::points_text(lab.points()),
                                   check::points_text(lab.adjusted())));
    else if (lab.days_late > 0)
        list.push_back(grade::lateness_text(lab));
    if (!lab.kept.empty()) list.push_back(lab.kept);
    if (lab.hand_ins > 0) list.push_back(grade::hand_ins_text(lab));
    if (!lab.due) return list;
    std::string due = "due " + grade::moment_text(*lab.due, offset);
    if (lab.extension_days > 0) {
        due += fmt::format(", with {} of extension", amount_of(lab.extension_days, "day"));
        if (reader == PageFor::instructor && !lab.extension_note.empty())
            due += ": " + grade::printable(lab.extension_note, 1000);
    }
    list.push_back(due);
    if (lab.handed_in_at) list.push_back("handed in " + grade::moment_text(*lab.handed_in_at, offset));
    return list;
}

std::string rendered(const grade::StudentRecord& record, grade::UtcOffset offset, PageFor reader) {
    List labs;
    bool has_more = record.labs.size() > 1;
    for (const grade::LabRecord& lab : record.labs) {
        List why = reasons(lab, offset, reader);
        has_more |= !why.empty();
        labs.push_back(Fields{{"number", number_of(lab.lab)},
                              {"title", lab_title(lab.lab)},
                              {"points", lab.marked ? check::points_text(lab.points()) : "?"},
                              {"of", lab.of()},
                              {"missing", !lab.handed_in},
                              {"reasons", rows(std::move(why))}});
    }
    List notes;
    for (const grade::Adjustment& one : record.adjustments)
        notes.push_back(Fields{{"task", one.task},
                               {"points", (one.points > 0 ? "+" : "") + amount_of(one.points, "point")},
                               {"note", grade::printable(one.note, 1000)}});
    List files;
    if (record.mark) files.insert(files.end(), record.mark->remarks.begin(), record.mark->remarks.end());
    files.insert(files.end(), record.team_remarks.begin(), record.team_remarks.end());
    std::string late_days;
    if (record.bank_days > 0)
        late_days = fmt::format("Late days used in this term: {} of {}", record.bank_used, record.bank_days);
    return render("framework/staff/pages/record", {{"has_points", record.is_marked() && record.of() > 0},
                                                   {"points", check::points_text(record.points())},
                                                   {"of", record.of()},
                                                   {"late_days", late_days},
                                                   {"labs", has_more ? rows(std::move(labs)) : Value()},
                                                   {"notes", rows(std::move(notes))},
                                                   {"files", rows(std::move(files))}});
}

}  // namespace

std::string with_record(const std::string& page, const grade::StudentRecord& record, grade::UtcOffset offset,
                        PageFor reader) {
    const size_t begin = page.find(begin_mark), end = page.find(end_mark, begin);
    if (begin == std::string::npos || end == std::string::npos) return page;
    const size_t inside = begin + begin_mark.size();
    return page.substr(0, inside) + "\n" + rendered(record, offset, reader) + page.substr(end);
}

}  // namespace relief::pages
