#include "framework/staff/pages/student_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "framework/core/base/error.h"
#include "framework/core/lab/registry.h"
#include "framework/course/check/verdict.h"
#include "framework/course/pages/check_figures.h"
#include "framework/course/pages/page.h"
#include "framework/staff/pages/record_part.h"

namespace relief::pages {
namespace {

class StudentPage {
public:
    StudentPage(const grade::SubmissionMark& mark, const std::vector<grade::CheckPictures>& pictures, PageFor reader)
        : mark_(mark), pictures_(pictures), for_student_(reader == PageFor::student) {}

    Fields fields() {
        List labs;
        bool has_tasks = false;
        for (const grade::LabMark& lab : mark_.labs) labs.push_back(of(lab)), has_tasks |= !lab.tasks.empty();
        return {{"name", grade::printable(mark_.name)},
                {"lost", lost()},
                {"for_student", for_student_},
                {"graded", mark_.graded()},
                {"problem", mark_.problem},
                {"has_tasks", has_tasks},
                {"labs", std::move(labs)},
                {"ignored", ignored()},
                {"any_hidden", any_hidden_},
                {"lost_pictures", lost_pictures_ && !for_student_}};
    }

private:
    Fields of(const grade::LabMark& lab) {
        List tasks;
        for (const check::TaskVerdict& task : lab.tasks) tasks.push_back(of(lab, task));
        return {{"number", number_of(lab.lab)},
                {"title", lab_title(lab.lab)},
                {"graded", lab.graded()},
                {"points", check::points_text(lab.points())},
                {"no_points", lab.points() == 0},
                {"of", lab.max_points()},
                {"log", lab.log},
                {"tasks", std::move(tasks)}};
    }

    Fields of(const grade::LabMark& lab, const check::TaskVerdict& task) {
        task_has_pictures_ = false;
        told_.clear();
        List checks;
        for (const check::Verdict& check : task.checks) {
            any_hidden_ |= check.hidden;
            const bool is_secret = for_student_ && (check.hidden || !check.view.empty());
            checks.push_back(is_secret ? secret(task, check) : of(lab, task, check));
        }
        return {{"id", task.id},
                {"title", task.title},
                {"file", task.file},
                {"points", check::points_text(task.points())},
                {"of", task.of},
                {"optional", task.optional ? "optional " : ""},
                {"worst", badge(task.worst())},
                {"mistake", task.hint.empty() ? "" : task.mistake},
                {"hint", with_code(task.hint)},
                {"checks", std::move(checks)}};
    }

    Fields of(const grade::LabMark& lab, const check::TaskVerdict& task, const check::Verdict& check) {
        const grade::CheckPictures* const shown = pictures_of(lab, task, check);
        const check::Verdict* const before = &check == &task.checks.front() ? nullptr : &check - 1;
        const bool as_above = !shown && before && before->outcome == check.outcome && before->found == check.found;
        const bool open = check.outcome != check::Outcome::passed && !as_above,
                   wrong = check.outcome == check::Outcome::wrong;
        const bool hidden_view = open && shown && shown->hidden_view;
        any_hidden_ |= hidden_view;
        lost_pictures_ |= open && !shown && wrong;
        const bool unfolded = !(shown && task_has_pictures_);
        task_has_pictures_ |= open && shown;
        Value pictures;
        if (open && shown) {
            Fields figures =
                check_figures(*shown->manifest, shown->check, shown->drawn, shown->expected, DrawnBy::submission);
            tell_once(figures, told_);
            pictures = std::move(figures);
        }
        return {{"open", open},
                {"unfolded", unfolded},
                {"badge", badge(check.outcome)},
                {"name", check.name},
                {"hidden", check.hidden},
                {"hidden_view", hidden_view},
                {"said", check.outcome == check::Outcome::passed ? check.found : "as above"},
                {"facts", facts({{wrong ? "found" : "message", check.found},
                                 {"view", check.view},
                                 {"why this limit", wrong && shown ? shown->check.reason : ""},
                                 {"look at", with_code(first_hint(task, check))}})},
                {"pictures", std::move(pictures)}};
    }

    /// Returns the check's hint, unless an earlier failed check of the task has shown the same one, or the hint of a
    /// known mistake stands above.
    static std::string first_hint(const check::TaskVerdict& task, const check::Verdict& check) {
        if (!task.hint.empty() && check.outcome == check::Outcome::wrong && !check.hidden) return {};
        for (const check::Verdict* other = &task.checks.front(); other != &check; ++other)
            if (other->outcome != check::Outcome::passed && other->look_at == check.look_at) return {};
        return check.look_at;
    }

    /// Returns the fields of a check that a student may see without its views.
    static Fields secret(const check::TaskVerdict& task, const check::Verdict& check) {
        const bool passed = check.outcome == check::Outcome::passed;
        Fields outcome = badge(check.outcome);
        if (check.hidden && passed) outcome["words"] = "hidden check: passed";
        List known =
            facts({{"found", grade::found_for_students(check)}, {"look at", with_code(first_hint(task, check))}});
        return {{"open", !passed && !known.empty()},
                {"unfolded", true},
                {"badge", std::move(outcome)},
                {"name", !check.hidden ? check.name
                         : passed      ? ""
                                       : "hidden check"},
                {"hidden", false},
                {"hidden_view", false},
                {"said", ""},
                {"facts", std::move(known)},
                {"pictures", Value()}};
    }

    /// Returns the texts as facts, one of which can contain code; empty ones are omitted.
    static List facts(const std::vector<std::pair<const char*, Value>>& all) {
        List facts;
        for (const auto& [name, value] : all) {
            List parts = value.list;
            if (value.kind == Value::Kind::text) parts = {Fields{{"code", ""}, {"text", value}}};
            if (!parts.empty()) facts.push_back(Fields{{"name", name}, {"value", std::move(parts)}});
        }
        return facts;
    }

    const grade::CheckPictures* pictures_of(const grade::LabMark& lab, const check::TaskVerdict& task,
                                            const check::Verdict& check) const {
        for (const grade::CheckPictures& one : pictures_)
            if (one.lab == lab.lab && one.check.task == task.id && one.check.name == check.name) return &one;
        return nullptr;
    }

    /// Returns the tasks that lost points, with all known details.
    Value lost() const {
        List tasks;
        for (const grade::LabMark& lab : mark_.labs) {
            if (!lab.graded()) continue;
            for (const check::TaskVerdict& task : lab.tasks)
                if (task.points() < task.of)
                    tasks.push_back(Fields{{"id", task.id},
                                           {"title", task.title},
                                           {"points", check::points_text(task.points())},
                                           {"of", task.of},
                                           {"hint", rows(with_code(task.hint).list)}});
        }
        return rows(std::move(tasks));
    }

    Value ignored() const {
        if (mark_.ignored_count == 0) return {};
        const size_t more = mark_.ignored_count - std::min(mark_.ignored.size(), mark_.ignored_count);
        return Fields{{"counted", count_of(mark_.ignored_count, "other file")},
                      {"names", List(mark_.ignored.begin(), mark_.ignored.end())},
                      {"more", more > 0 ? std::to_string(more) : ""}};
    }

    const grade::SubmissionMark& mark_;
    const std::vector<grade::CheckPictures>& pictures_;
    bool for_student_;
    bool any_hidden_ = false, lost_pictures_ = false;
    bool task_has_pictures_ = false;  ///< only the first pictures of a task are unfolded
    std::set<std::string> told_;      ///< probes of the task whose colours are explained
};

}  // namespace

std::string number_of(const std::string& folder) { return folder.substr(0, folder.find('_')); }
std::string lab_title(const std::string& folder) {
    static const std::map<std::string, std::string> titles = [] {
        std::map<std::string, std::string> all;
        for (const LabEntry& lab : registry()) try {
                all[lab.folder] = load_manifest(lab).title;
            } catch (const Error&) {  // existing marks can be shown without that lab
            }
        return all;
    }();
    if (const auto title = titles.find(folder); title != titles.end()) return title->second;
    const size_t at = folder.find('_');
    std::string words = at == std::string::npos ? folder : folder.substr(at + 1);
    std::replace(words.begin(), words.end(), '_', ' ');
    return words;
}

std::string count_of(size_t count, const std::string& what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string student_page(const grade::SubmissionMark& mark, const std::vector<grade::CheckPictures>& pictures,
                         PageFor reader) {
    const std::string page = render({.title = grade::printable(mark.name),
                                     .body = "framework/staff/pages/student",
                                     .styles = {"badge", "checks", "figures", "framework/staff/pages/student"},
                                     .scripts = {"wipe", "checks"}},
                                    StudentPage(mark, pictures, reader).fields());
    return with_record(page, grade::record_of(mark), grade::UtcOffset(0), reader);
}

}  // namespace relief::pages
