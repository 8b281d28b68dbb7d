#include "framework/staff/pages/grade_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "framework/core/base/text.h"
#include "framework/course/check/verdict.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/pages/page.h"
#include "framework/staff/pages/student_page.h"
#include "framework/staff/pages/summaries.h"

namespace relief::pages {
namespace {

constexpr int outcomes = int(check::Outcome::machine) + 1;
using Counts = std::array<size_t, outcomes>;

/// Returns a known mistake as one word for the filter. It starts with the task, since ids are unique only within a lab.
std::string named(const check::TaskVerdict& task) { return task.id + "\u00a0" + task.mistake; }

/// All counts over a class.
class ClassCounts {
public:
    struct OfCheck {
        std::string task, name;
        bool hidden = false;
        Counts of{};
        size_t all() const {
            size_t sum = 0;
            for (const size_t count : of) sum += count;
            return sum;
        }
        size_t passed() const { return of[size_t(check::Outcome::passed)]; }
    };
    struct OfMistake {
        std::string hint;
        size_t count = 0;
    };
    std::map<std::string, std::vector<OfCheck>> checks;  ///< by lab, in the order of its tasks
    std::map<std::string, OfMistake> mistakes;           ///< by named()
    std::set<std::string> isolations;
    grade::MarkTimes times;
    double waiting = 0;
    size_t not_graded = 0;
    size_t absent = 0, strangers = 0;  ///< without a submission; and with one, but not in the roster
    std::vector<double> points;        ///< of students with a submission

    explicit ClassCounts(const grade::ClassRecord& record) {
        for (const grade::StudentRecord& one : record.students) {
            absent += !one.mark && !one.is_waiting;
            not_graded += one.is_waiting;
            strangers += !one.on_roster;
            if (!one.mark) continue;
            if (one.is_marked())
                points.push_back(one.points());
            else
                ++not_graded;
            add(*one.mark);
        }
        std::sort(points.begin(), points.end());
    }

    double median() const {
        return points.empty() ? 0 : 0.5 * (points[(points.size() - 1) / 2] + points[points.size() / 2]);
    }

private:
    void add(const grade::SubmissionMark& mark) {
        if (!mark.isolation.empty()) isolations.insert(mark.isolation);
        double busy = 0;
        for (const grade::LabMark& lab : mark.labs) {
            times.add(lab.times);
            busy += lab.times.sum();
            for (const check::TaskVerdict& task : lab.tasks) add(lab.lab, task);
        }
        waiting += std::max(0.0, mark.seconds - busy);
    }

    void add(const std::string& lab, const check::TaskVerdict& task) {
        for (const check::Verdict& check : task.checks) {
            std::vector<OfCheck>& known = checks[lab];
            const auto [entry, is_new] = place_.try_emplace({lab, task.id, check.name}, known.size());
            if (is_new) known.push_back({task.id, check.name, check.hidden});
            ++known[entry->second].of[size_t(check.outcome)];
        }
        if (task.mistake.empty()) return;
        OfMistake& mistake = mistakes[named(task)];
        mistake.hint = task.hint;
        ++mistake.count;
    }

    std::map<std::array<std::string, 3>, size_t> place_;
};

List number_cards(const grade::ClassReport& report, const ClassCounts& counts) {
    List cards;
    const auto add = [&](const char* name, const std::string& value, const char* kind = "") {
        cards.push_back(Fields{{"name", name}, {"value", value}, {"kind", kind}});
    };
    add("submissions", std::to_string(report.marks.size()));
    add("median", amount_of(counts.median(), "point"));
    if (counts.not_graded > 0) add("not graded: grade again", std::to_string(counts.not_graded), "bad");
    if (counts.absent > 0) add("nothing handed in", std::to_string(counts.absent));
    if (counts.strangers > 0) add("not on the roster", std::to_string(counts.strangers), "bad");
    add("unchanged, not graded again", std::to_string(report.taken_over));
    return cards;
}

/// Returns the count of each outcome from `first` on, for {{> badge}} and similar templates. Omits counts of 0.
List outcome_counts(const Counts& of, check::Outcome first) {
    List list;
    for (int i = int(first); i < outcomes; ++i)
        if (of[size_t(i)] > 0) {
            Fields one = badge(check::Outcome(i), of[size_t(i)]);
            one["is_first"] = list.empty();
            list.push_back(std::move(one));
        }
    return list;
}

Fields points_cell(const std::string& column, double points, int of, const char* instead = "") {
    return {{"column", column},
            {"share", *instead || of == 0 ? "" : fmt::format("{:.0f}", 100 * points / of)},
            {"points", check::points_text(points)},
            {"of", of},
            {"instead", *instead ? instead : "–"}};
}

Fields cell_of(const grade::LabRecord& lab) {
    const bool is_missing = !lab.handed_in && lab.points() == 0;
    return points_cell("lab " + number_of(lab.lab), lab.points(), lab.of(),
                       is_missing   ? "–"
                       : lab.marked ? ""
                                    : "not graded");
}

/// Returns a row of the class table: points by lab, counts of check outcomes, recognised mistakes, and adjustments by
/// people and rules.
Fields line_of(const grade::StudentRecord& record) {
    List cells;
    for (const grade::LabRecord& lab : record.labs) cells.push_back(cell_of(lab));
    Counts of{};
    std::set<std::string> mistakes;
    size_t all = 0;
    if (record.mark)
        for (const grade::LabMark& lab : record.mark->labs)
            for (const check::TaskVerdict& task : lab.tasks) {
                for (const check::Verdict& check : task.checks) ++of[size_t(check.outcome)], ++all;
                if (!task.mistake.empty()) mistakes.insert(named(task));
            }
    const auto missing = record.mark ? std::count_if(record.labs.begin(), record.labs.end(),
                                                     [](const grade::LabRecord& lab) { return !lab.handed_in; })
                                     : 0;
    List remarks;
    for (const std::string& remark : record.remarks()) remarks.push_back(remark);
    return {{"page", page_file(record.name, PageFor::instructor).string()},
            {"name", record.student.student},
            {"full_name", grade::printable(record.student.name)},
            {"stranger", !record.on_roster},
            {"total", points_cell("points", record.points(), record.of(), record.is_marked() ? "" : "not graded")},
            {"cells", std::move(cells)},
            {"problem", record.mark ? record.mark->problem : record.state()},
            {"all_passed", all > 0 && missing == 0 && of[size_t(check::Outcome::passed)] == all},
            {"missing", missing > 0 ? count_of(size_t(missing), "lab") + " not handed in" : ""},
            {"outcomes", outcome_counts(of, check::Outcome(1))},
            {"mistakes", List(mistakes.begin(), mistakes.end())},
            {"remarks", rows(std::move(remarks))}};
}

List labs_with_checks(const ClassCounts& counts) {
    List labs;
    for (const auto& [lab, known] : counts.checks) {
        List checks, passed;
        for (const ClassCounts::OfCheck& check : known)
            (check.passed() < check.all() ? checks : passed)
                .push_back(Fields{{"task", check.task},
                                  {"name", check.name},
                                  {"hidden", check.hidden},
                                  {"outcomes", outcome_counts(check.of, check::Outcome::passed)}});
        const std::string counted = count_of(passed.size(), checks.empty() ? "check" : "other check");
        labs.push_back(Fields{{"number", number_of(lab)},
                              {"title", lab_title(lab)},
                              {"checks", rows(std::move(checks))},
                              {"passed_by_all", passed.empty() ? "" : counted},
                              {"passed", std::move(passed)}});
    }
    return labs;
}

/// Returns the three checks with the smallest share of passes.
Value hardest_checks(const ClassCounts& counts) {
    std::vector<const ClassCounts::OfCheck*> hardest;
    for (const auto& [lab, checks] : counts.checks)
        for (const ClassCounts::OfCheck& check : checks)
            if (check.passed() < check.all()) hardest.push_back(&check);
    std::stable_sort(hardest.begin(), hardest.end(), [](const auto* a, const auto* b) {
        return double(a->passed()) * double(b->all()) < double(b->passed()) * double(a->all());
    });
    if (hardest.size() > 3) hardest.resize(3);
    List list;
    for (const ClassCounts::OfCheck* check : hardest)
        list.push_back(Fields{{"is_first", list.empty()},
                              {"task", check->task},
                              {"name", check->name},
                              {"passed", check->passed()},
                              {"all", check->all()}});
    return rows(std::move(list));
}

Value known_mistakes(const ClassCounts& counts) {
    std::vector<std::pair<std::string, ClassCounts::OfMistake>> mistakes(counts.mistakes.begin(),
                                                                         counts.mistakes.end());
    std::stable_sort(mistakes.begin(), mistakes.end(),
                     [](const auto& a, const auto& b) { return a.second.count > b.second.count; });
    List list;
    for (const auto& [id, mistake] : mistakes)
        list.push_back(Fields{{"id", id}, {"hint", with_code(mistake.hint)}, {"count", mistake.count}});
    return rows(std::move(list));
}

Value times(const ClassCounts& counts) {
    const double all = counts.times.sum() + counts.waiting;
    if (all <= 0) return {};
    const std::tuple<const char*, double, const char*> parts[] = {
        {"compile", counts.times.compile, "compiling"},
        {"draw", counts.times.draw, "drawing"},
        {"compare", counts.times.compare, "comparing"},
        {"waiting", counts.waiting, "waiting, reading and recognising known mistakes"}};
    List list;
    for (const auto& [kind, seconds, words] : parts)
        list.push_back(Fields{{"kind", kind},
                              {"words", words},
                              {"share", fmt::format("{:.4f}", seconds / all)},
                              {"percent", fmt::format("{:.0f}", 100 * seconds / all)},
                              {"seconds", fmt::format("{:.1f}", seconds)}});
    return rows(std::move(list));
}

/// Returns the table of late days and graded hand-ins: a row for each student who used any.
Value used_table(const grade::ClassRecord& record) {
    if (!grade::has_limits(record.policy)) return {};
    List students;
    for (const grade::StudentRecord& one : record.students) {
        List labs;
        int graded = 0;
        for (const grade::LabRecord& lab : one.labs) {
            graded += lab.hand_ins;
            const std::string number = "lab " + number_of(lab.lab) + ": ";
            if (lab.days_late > 0) labs.push_back(number + grade::lateness_text(lab));
            if (lab.hand_ins > 0) labs.push_back(number + grade::hand_ins_text(lab));
            if (!lab.kept.empty()) labs.push_back(number + lab.kept);
        }
        if (labs.empty() && one.bank_used == 0) continue;
        students.push_back(Fields{{"name", one.student.student},
                                  {"used", one.bank_used},
                                  {"left", one.bank_days - one.bank_used},
                                  {"graded", graded},
                                  {"labs", rows(std::move(labs))}});
    }
    return Fields{{"bank", record.policy.late.bank_days > 0},
                  {"limit", record.policy.hand_ins_per_day > 0},
                  {"students", rows(std::move(students))}};
}

}  // namespace

std::string class_page(const grade::ClassReport& report) {
    return class_page(report, grade::class_record(report.marks, {}, {}));
}

std::string class_page(const grade::ClassReport& report, const grade::ClassRecord& record) {
    const ClassCounts counts(record);
    List submissions, columns;
    bool has_remarks = false;
    for (const grade::StudentRecord& one : record.students) {
        submissions.push_back(line_of(one));
        has_remarks |= !one.remarks().empty();
    }
    if (!record.students.empty())
        for (const grade::LabRecord& lab : record.students.front().labs)
            columns.push_back(Fields{{"number", number_of(lab.lab)}, {"title", lab_title(lab.lab)}});
    const Fields run{{"seconds", fmt::format("{:.1f}", report.seconds)},
                     {"prepared", fmt::format("{:.1f}", report.prepared)}};
    return render(
        {.title = "Marks: " + count_of(report.marks.size(), "submission"),
         .body = "framework/staff/pages/class",
         .styles = {"badge", "framework/staff/pages/class"},
         .scripts = {"framework/staff/pages/class"}},
        {{"numbers", number_cards(report, counts)},
         {"isolated_by", join(std::vector<std::string>(counts.isolations.begin(), counts.isolations.end()), ", ")},
         {"isolation", report.isolation.level == grade::Isolation::limits ? report.isolation.reason : ""},
         {"is_long", record.students.size() > 50},
         {"columns", std::move(columns)},
         {"has_remarks", has_remarks},
         {"used", used_table(record)},
         {"labs", labs_with_checks(counts)},
         {"submissions", std::move(submissions)},
         {"hardest", hardest_checks(counts)},
         {"mistakes", known_mistakes(counts)},
         {"run", report.prepared > 0 ? Value(run) : Value()},
         {"times", times(counts)}});
}

}  // namespace relief::pages
