#include "framework/staff/class/exports.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/core/base/text.h"
#include "framework/staff/class/csv.h"
#include "framework/staff/class/progress.h"
#include "framework/staff/grade/strangers_text.h"

namespace relief::grade {
namespace {

using nlohmann::ordered_json;
using Cells = std::vector<std::string>;

/// Replaces invalid UTF-8, which untrusted text may contain.
std::string dump(const ordered_json& json) {
    return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string number_of_lab(const std::string& folder) { return folder.substr(0, folder.find('_')); }

/// Returns the name of a student for people to read.
std::string shown_name(const Student& student) { return student.name.empty() ? student.student : student.name; }

std::string cell(const std::string& text) { return defused(printable(text, 2000)); }

/// Returns points for other systems, which round as they like: the sum of shares, without the digits that binary
/// fractions add.
std::string decimal(double points) { return rounded(points, 10); }

// ---- XML ----

/// Returns untrusted text as valid XML 1.0: UTF-8, without control characters, U+FFFE and U+FFFF.
std::string xml(const std::string& text) {
    std::string result = printable(text, 4000);
    for (const std::string bad : {"\xef\xbf\xbe", "\xef\xbf\xbf"})
        for (size_t at; (at = result.find(bad)) != std::string::npos;) result.replace(at, bad.size(), "?");
    return escaped_markup(result);
}

/// The checks of a submission as the elements of a suite.
struct Suite {
    int tests = 0, failures = 0, errors = 0;
    double seconds = 0;
    std::string cases, properties;
};

Suite suite_of(const StudentRecord& record) {
    Suite suite;
    const auto add = [&](const std::string& group, const std::string& name, const char* kind, const char* type,
                         const std::string& message) {
        ++suite.tests;
        suite.failures += kind && std::string_view(kind) == "failure";
        suite.errors += kind && std::string_view(kind) == "error";
        suite.cases += fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"", xml(group), xml(name));
        suite.cases +=
            kind ? fmt::format("><{} type=\"{}\" message=\"{}\"/></testcase>\n", kind, type, xml(message)) : "/>\n";
    };
    if (!record.mark)
        add("submission", "is there", record.is_waiting ? "error" : "failure", "missing", record.state());
    else {
        const SubmissionMark& mark = *record.mark;
        suite.seconds = mark.seconds;
        if (!mark.problem.empty()) add("submission", "can be read", "failure", "unreadable", mark.problem);
        for (const LabMark& lab : mark.labs)
            for (const check::TaskVerdict& task : lab.tasks)
                for (const check::Verdict& check : task.checks) {
                    const bool passed = check.outcome == check::Outcome::passed,
                               machine = check.outcome == check::Outcome::machine;
                    add(lab.lab + "." + task.id, check.name,
                        passed    ? nullptr
                        : machine ? "error"
                                  : "failure",
                        name_of(check.outcome), check.found);
                }
    }
    const auto property = [&](const char* name, const std::string& value) {
        suite.properties += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", name, xml(value));
    };
    if (record.is_marked()) property("points", check::points_text(record.points()));
    property("max_points", std::to_string(record.of()));
    for (const std::string& remark : record.remarks()) property("remark", remark);
    suite.properties = "    <properties>\n" + suite.properties + "    </properties>\n";
    return suite;
}

// ---- JSON ----

/// Returns the check's hint on a line of its own, for systems that show plain text.
std::string look_at(const check::Verdict& check) {
    return check.look_at.empty() ? "" : "\nlook at: " + without_backticks(check.look_at);
}

/// Returns the text for a check on Gradescope, which shows hidden checks to instructors only.
std::string sentence(const check::Verdict& check) {
    return (check.hidden ? check.found : found_for_students(check)) + look_at(check);
}

/// Returns the pictures of a check that its student may see: it failed, and neither it nor its view is hidden.
std::vector<const ExportPicture*> pictures_of(const LabMark& lab, const check::TaskVerdict& task,
                                              const check::Verdict& check, const std::vector<ExportPicture>& pictures) {
    std::vector<const ExportPicture*> shown;
    if (check.outcome == check::Outcome::passed || check.hidden || !check.view.empty()) return shown;
    for (const ExportPicture& one : pictures)
        if (one.lab == lab.lab && one.task == task.id && one.check == check.name) shown.push_back(&one);
    return shown;
}

/// Returns HTML: the text as it is, and the pictures below it.
std::string with_pictures(const std::string& text, const std::vector<const ExportPicture*>& pictures) {
    std::string html =
        "<pre style=\"white-space: pre-wrap\">" + escaped_markup(printable_lines(text, 4000)) + "</pre>\n";
    for (const ExportPicture* one : pictures)
        html += fmt::format(
            "<figure style=\"display: inline-block; margin: 0 8px 8px 0\"><img alt=\"{0}\" src=\"{1}\">"
            "<figcaption>{0}</figcaption></figure>\n",
            escaped_markup(one->label), escaped_markup(one->uri));
    return html;
}

/// Returns the adjustments by people and rules, one line each.
std::string remarks_text(const StudentRecord& record) {
    std::string text;
    for (const std::string& remark : record.remarks()) text += remark + "\n";
    if (record.is_changed())
        text +=
            fmt::format("The checks alone gave {} of {} points.\n", check::points_text(record.graded()), record.of());
    return text;
}

// ---- Moodle ----

/// Returns a key for an identifier in a worksheet's column. Ignores the case of addresses and user names, because
/// systems differ in it.
std::string key_of(const std::string& column, std::string value) {
    for (char& c : value)
        if (column != "ID number" && c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return column + ' ' + value;
}

/// Returns the student of a row, found by any identifier that both sides have; null if there is none.
const StudentRecord* student_of(const CsvTable& sheet, const CsvRow& row,
                                const std::map<std::string, const StudentRecord*>& by) {
    for (const char* column : {"Email address", "Username", "ID number"}) {
        const std::string& value = sheet.cell(row, column);
        if (value.empty()) continue;
        if (const auto found = by.find(key_of(column, value)); found != by.end()) return found->second;
    }
    return nullptr;
}

}  // namespace

std::string to_csv(const ClassRecord& record) {
    const bool has_roster = !record.policy.students.empty();
    const std::vector<LabRecord> labs =
        record.students.empty() ? std::vector<LabRecord>() : record.students.front().labs;
    Cells head{"submission", "state", "points", "of"};
    if (has_roster) head.insert(head.end(), {"name", "email", "login", "canvas_id", "sis_id", "section"});
    const bool teams = has_teams(record.policy);
    if (teams) head.push_back("team");
    head.insert(head.end(), {"by the checks", "adjusted by", "late by", "remarks"});
    if (record.policy.late.bank_days > 0)
        head.push_back(fmt::format("late days used (of {})", record.policy.late.bank_days));
    for (const LabRecord& lab : labs) head.push_back(fmt::format("lab {} (of {})", number_of_lab(lab.lab), lab.of()));
    for (const LabRecord& lab : labs)
        for (const TaskRecord& task : lab.tasks)
            head.push_back(fmt::format("{} (of {}{})", task.id, task.of, task.optional ? ", optional" : ""));
    std::string text = csv_line(head);
    for (const StudentRecord& one : record.students) {
        const bool marked = one.is_marked();
        const auto points = [&](double value) { return marked ? check::points_text(value) : std::string(); };
        Cells cells{cell(one.student.student), cell(one.state()), points(one.points()), std::to_string(one.of())};
        if (has_roster)
            for (const std::string& word : {one.student.name, one.student.email, one.student.login,
                                            one.student.canvas_id, one.student.sis_id, one.student.section})
                cells.push_back(cell(word));
        if (teams) cells.push_back(cell(one.student.team));
        cells.insert(cells.end(), {points(one.graded()), points(one.adjusted() - one.graded()),
                                   points(one.points() - one.adjusted()), cell(join(one.remarks(), "; "))});
        if (record.policy.late.bank_days > 0) cells.push_back(std::to_string(one.bank_used));
        for (const LabRecord& lab : one.labs) cells.push_back(lab.marked ? check::points_text(lab.points()) : "");
        for (const LabRecord& lab : one.labs)
            for (const TaskRecord& task : lab.tasks)
                cells.push_back(
                    !lab.marked || (!lab.handed_in && task.adjusted == 0) ? "" : check::points_text(task.adjusted));
        text += csv_line(cells);
    }
    return text;
}

std::string to_late_days(const ClassRecord& record) {
    const UtcOffset offset = record.policy.utc_offset;
    std::string text = csv_line(Cells{"submission", "lab", "due", "handed in", "days late", "cost nothing",
                                      "cost points", "used in the term", "left in the term", "hand-ins graded",
                                      "last graded on", "graded on that day", "remark"});
    for (const StudentRecord& one : record.students)
        for (const LabRecord& lab : one.labs)
            text += csv_line(
                Cells{cell(one.student.student), number_of_lab(lab.lab), lab.due ? moment_text(*lab.due, offset) : "",
                      lab.handed_in_at ? moment_text(*lab.handed_in_at, offset) : "", std::to_string(lab.days_late),
                      std::to_string(lab.bank_days), std::to_string(lab.days_late - lab.bank_days),
                      std::to_string(one.bank_used), std::to_string(one.bank_days - one.bank_used),
                      std::to_string(lab.hand_ins), lab.last_day, std::to_string(lab.on_last_day), cell(lab.kept)});
    return text;
}

std::string to_canvas(const ClassRecord& record) {
    Cells head{"Student", "ID", "SIS User ID", "SIS Login ID", "Section"},
        points{"    Points Possible", "", "", "", ""};
    for (const AssignedLab& lab : record.policy.labs) {
        if (record.students.empty() || !record.students.front().lab(lab.folder)) continue;
        head.push_back(cell(lab.canvas));
        points.push_back(decimal(record.students.front().lab(lab.folder)->of()));
    }
    std::string text = csv_line(head) + csv_line(points);
    for (const StudentRecord& one : record.students) {
        if (!one.on_roster) continue;
        Cells cells{cell(shown_name(one.student)), cell(one.student.canvas_id), cell(one.student.sis_id),
                    cell(one.student.login), cell(one.student.section)};
        for (const LabRecord& lab : one.labs) cells.push_back(lab.marked ? decimal(lab.points()) : "");
        text += csv_line(cells);
    }
    return text;
}

std::string to_moodle(const ClassRecord& record, const AssignedLab& lab, std::vector<std::string>& notes) {
    const CsvTable sheet = read_csv(lab.moodle);
    const int grade = sheet.column("Grade"), feedback = sheet.column("Feedback comments");
    // Moodle itself rejects a worksheet without these.
    for (const char* column : {"Identifier", "Grade", "Last modified (grade)"})
        if (sheet.column(column) < 0)
            throw Error({lab.moodle, 1},
                        fmt::format("has no column '{}': download Moodle's grading worksheet again, with "
                                    "Moodle set to English",
                                    column));
    std::map<std::string, const StudentRecord*> by;
    for (const StudentRecord& one : record.students)
        for (const auto& [column, value] : {std::pair("Email address", &one.student.email),
                                            {"Username", &one.student.login},
                                            {"ID number", &one.student.sis_id}})
            if (!value->empty()) by.emplace(key_of(column, *value), &one);
    std::string text = csv_line(sheet.columns);
    Cells unknown;
    for (const CsvRow& row : sheet.rows) {
        Cells cells = row.cells;
        const StudentRecord* const one = student_of(sheet, row, by);
        const auto max = parse_number(sheet.cell(row, "Maximum Grade"));
        if (!max || *max <= 0)
            throw Error({lab.moodle, row.line},
                        "'Maximum Grade' must be a number of points, as in 6.00: in Moodle, let the "
                        "assignment have points, and download the worksheet in English");
        if (!one) unknown.push_back(sheet.cell(row, "Identifier"));
        const LabRecord* const points = one ? one->lab(lab.folder) : nullptr;
        if (points && points->marked && sheet.cell(row, "Grade can be changed") != "No") {
            cells[size_t(grade)] = decimal(points->of() > 0 ? *max * points->points() / points->of() : 0);
            if (feedback >= 0) {
                std::string words = fmt::format("{} of {} points", check::points_text(points->points()), points->of());
                if (!points->handed_in) words += "; nothing handed in";
                for (const std::string& remark : one->remarks(lab.folder)) words += "; " + remark;
                cells[size_t(feedback)] = defused(words);
            }
        }
        text += csv_line(cells);
    }
    if (!unknown.empty())
        notes.push_back(fmt::format("{}: {} of {} rows have no email address, username or ID number of the roster: {}",
                                    lab.moodle.filename().string(), unknown.size(), sheet.rows.size(),
                                    some_of(unknown)));
    return text;
}

std::string to_prairielearn(const StudentRecord& record, const std::vector<ExportPicture>& pictures) {
    constexpr size_t max_bytes = 1'000'000;
    if (!record.is_marked())  // not counted as an attempt
        return dump({{"gradable", false},
                     {"message", "The grader's machine failed. This is not your fault and costs you no points."}});
    if (record.mark && !record.mark->problem.empty())
        return dump({{"gradable", false}, {"format_errors", {printable(record.mark->problem, 1000)}}});
    const double of_all = record.of() > 0 ? record.points() / record.of() : 0;
    ordered_json json = {{"gradable", true},
                         {"score", std::clamp(of_all, 0.0, 1.0)},
                         {"message", fmt::format("{} of {} points", check::points_text(record.points()), record.of())},
                         {"output", remarks_text(record)},
                         {"tests", ordered_json::array()}};
    if (record.mark)
        for (const LabMark& lab : record.mark->labs)
            for (const check::TaskVerdict& task : lab.tasks)
                for (const check::Verdict& check : task.checks) {
                    const check::TaskVerdict::Share share = task.share_of(check);
                    json["tests"].push_back(
                        {{"name",
                          fmt::format("{} {}: {}", task.id, task.title, check.hidden ? "a hidden check" : check.name)},
                         {"points", share.points},
                         {"max_points", share.of},
                         {"message", std::string(name_of(check.outcome))},
                         {"output", printable_lines(found_for_students(check) + look_at(check), 4000)}});
                    for (const ExportPicture* one : pictures_of(lab, task, check, pictures))
                        json["tests"].back()["images"].push_back({{"label", one->label}, {"url", one->uri}});
                }
    std::string text = dump(json);
    if (text.size() <= max_bytes) return text;
    for (ordered_json& test : json["tests"]) test.erase("images");
    text = dump(json);
    if (text.size() <= max_bytes) return text;
    for (ordered_json& test : json["tests"]) test.erase("output");
    json["output"] = "There is more on the page that your instructor has.";
    return dump(json);
}

std::string to_gradescope(const StudentRecord& record, const std::vector<ExportPicture>& pictures) {
    // Sets plain text: otherwise Gradescope would interpret markup in a submission's output.
    ordered_json json = {{"output_format", "text"}, {"test_output_format", "text"}, {"test_name_format", "text"}};
    if (!record.mark || !record.is_marked()) {  // without a score, Gradescope reports that grading failed
        json["output"] = record.mark ? "The grader's machine failed. This is not your fault and costs you no points."
                                     : record.state();
        return dump(json);
    }
    const SubmissionMark& mark = *record.mark;
    bool any_hidden = false;
    ordered_json tests = ordered_json::array();
    const auto add = [&](const std::string& name, const LabMark& lab, const ordered_json& more) {
        ordered_json test = {{"name", name}, {"name_format", "text"}};
        test.update({{"output_format", "text"}});
        test.update(more);
        test.update({{"tags", {lab.lab}}});
        tests.push_back(std::move(test));
    };
    for (const LabMark& lab : mark.labs)
        for (const check::TaskVerdict& task : lab.tasks) {
            for (const check::Verdict& check : task.checks) {
                const check::TaskVerdict::Share share = task.share_of(check);
                const bool passed = check.outcome == check::Outcome::passed;
                any_hidden |= check.hidden;
                add(fmt::format("{} {}: {}", task.id, task.title, check.name), lab,
                    {{"score", share.points},
                     {"max_score", share.of},
                     {"status", passed ? "passed" : "failed"},
                     {"output", fmt::format("{}: {}", name_of(check.outcome), sentence(check))},
                     {"visibility", check.hidden ? "hidden" : "visible"}});
                if (const auto shown = pictures_of(lab, task, check, pictures); !shown.empty())
                    tests.back().update(
                        {{"output", with_pictures(tests.back()["output"], shown)}, {"output_format", "html"}});
            }
            if (!task.hint.empty())
                add(fmt::format("{} {}: a hint", task.id, task.title), lab,
                    {{"output", without_backticks(task.hint)}, {"visibility", "visible"}});
        }
    std::string output = mark.problem.empty() ? "" : mark.problem + "\n";
    if (any_hidden)
        output +=
            "Some checks are hidden. Gradescope shows no total while a check is hidden; your points count all "
            "checks.\n";
    json.update({{"score", record.points()},
                 {"execution_time", mark.seconds},
                 {"output", output + remarks_text(record)},
                 {"visibility", "visible"},
                 {"tests", std::move(tests)}});
    return dump(json);
}

std::string to_junit(const ClassRecord& record, Moment written) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    const std::string time = moment_text(written, UtcOffset(0)),
                      stamp = time.substr(0, 10) + "T" + time.substr(11, 5) + ":00";
    int id = 0;
    for (const StudentRecord& one : record.students) {
        const Suite suite = suite_of(one);
        // Ant's schema requires all these attributes, a list of properties, and both kinds of output.
        text += fmt::format(
            "  <testsuite name=\"{0}\" package=\"relief\" id=\"{1}\" timestamp=\"{2}\" "
            "hostname=\"localhost\" tests=\"{3}\" failures=\"{4}\" errors=\"{5}\" skipped=\"0\" "
            "time=\"{6:.3f}\">\n{7}{8}    <system-out></system-out>\n    <system-err></system-err>\n"
            "  </testsuite>\n",
            xml(one.student.student), id++, stamp, suite.tests, suite.failures, suite.errors, suite.seconds,
            suite.properties, suite.cases);
    }
    return text + "</testsuites>\n";
}

std::string to_surefire(const StudentRecord& record) {
    const Suite suite = suite_of(record);
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"{}\" time=\"{:.3f}\" tests=\"{}\" "
        "errors=\"{}\" skipped=\"0\" failures=\"{}\">\n{}{}</testsuite>\n",
        xml(record.student.student), suite.seconds, suite.tests, suite.errors, suite.failures, suite.properties,
        suite.cases);
}

std::string to_table(const ClassRecord& record) {
    size_t width = 10;
    for (const StudentRecord& one : record.students)
        width = std::max(width, std::min<size_t>(40, one.student.student.size()));
    std::string text = fmt::format("{:<{}}", "submission", width);
    if (!record.students.empty())
        for (const LabRecord& lab : record.students.front().labs)
            text += fmt::format("  {:>7}", "lab " + number_of_lab(lab.lab));
    const bool has_bank = record.policy.late.bank_days > 0, is_limited = record.policy.hand_ins_per_day > 0;
    text += "       all";
    if (has_bank) text += "  late days";
    if (is_limited) text += "  hand-ins";
    text += "\n";
    // Columns of the students' cells, one for each lab, then the sum.
    const size_t labs = record.students.empty() ? 0 : record.students.front().labs.size();
    std::vector<std::vector<std::string>> columns(labs + 1);
    for (const StudentRecord& one : record.students) {
        for (size_t i = 0; i < labs; ++i) {
            const LabRecord& lab = one.labs[i];
            columns[i].push_back(!lab.handed_in && lab.points() == 0 ? "-"
                                 : !lab.marked                       ? "?"
                                               : fmt::format("{}/{}", check::points_text(lab.points()), lab.of()));
        }
        columns[labs].push_back(one.is_marked() ? fmt::format("{}/{}", check::points_text(one.points()), one.of())
                                                : "?");
    }
    for (size_t i = 0; i <= labs; ++i) columns[i] = aligned_at_points(std::move(columns[i]), i < labs ? 7 : 8);
    for (size_t student = 0; student < record.students.size(); ++student) {
        const StudentRecord& one = record.students[student];
        text += fmt::format("{:<{}}", one.student.student, width);
        for (const std::vector<std::string>& column : columns) text += "  " + column[student];
        if (has_bank) text += fmt::format("  {:>9}", fmt::format("{}/{}", one.bank_used, one.bank_days));
        if (is_limited) {
            int graded = 0;
            for (const LabRecord& lab : one.labs) graded += lab.hand_ins;
            text += fmt::format("  {:>8}", graded);
        }
        if (one.state() != "graded") text += "  " + one.state();
        if (one.is_marked() && one.adjusted() != one.graded())
            text += fmt::format("  adjusted by {}", check::points_text(one.adjusted() - one.graded()));
        if (one.is_marked() && one.points() != one.adjusted())
            text += fmt::format("  late: {} less", check::points_text(one.adjusted() - one.points()));
        for (const LabRecord& lab : one.labs)
            if (!lab.kept.empty())
                text += fmt::format("  lab {}: beyond the limit of hand-ins", number_of_lab(lab.lab));
        text += "\n";
    }
    return text;
}

}  // namespace relief::grade
