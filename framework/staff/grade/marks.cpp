#include "framework/staff/grade/marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <mutex>
#include <set>

#include "framework/core/base/error.h"
#include "framework/core/base/file.h"
#include "framework/core/base/paths.h"
#include "framework/course/check/starter.h"
#include "framework/staff/grade/transplant.h"
#include "framework/staff/grade/variation.h"

namespace relief::grade {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Returns why a task cannot be drawn, from its file alone; or nothing.
std::optional<check::Judgement> judge_file(const TaskInfo& task, const Submission& submission,
                                           const check::OtherShaders& others) {
    if (const auto refused = submission.refused.find(task.file); refused != submission.refused.end())
        return check::Judgement{check::Outcome::broken, fmt::format("{} is {}", task.file, refused->second)};
    const auto file = submission.files.find(task.file);
    if (file == submission.files.end())
        return check::Judgement{check::Outcome::unfinished, fmt::format("there is no {}", task.file)};
    if (is_shader(task.file))
        if (const std::string beyond = check::reaches_beyond(file->second, others); !beyond.empty())
            return check::Judgement{check::Outcome::broken, fmt::format("{} {}", task.file, printable(beyond))};
    if (check::is_unfinished(file->second, task.id))
        return check::Judgement{check::Outcome::unfinished, "not written yet"};
    return {};
}

/// Returns for each check why it cannot be drawn, or nothing.
std::vector<std::optional<check::Judgement>> judge_files(const Manifest& manifest, const Submission& submission,
                                                         const check::OtherShaders& others) {
    std::map<std::string, check::Judgement> given_up;  // by task
    for (const TaskInfo& task : manifest.tasks)
        if (const auto why = judge_file(task, submission, others)) given_up[task.id] = *why;
    const auto is_written = [&](const std::string& task) {
        const auto why = given_up.find(task);
        return why == given_up.end() || why->second.outcome != check::Outcome::unfinished;
    };
    std::vector<std::optional<check::Judgement>> by_check;
    for (const CheckInfo& check : manifest.checks) {
        std::optional<check::Judgement>& verdict = by_check.emplace_back();
        if (const auto why = given_up.find(check.task); why != given_up.end())
            verdict = why->second;
        else if (const check::TaskIds missing = check::missing_tasks(check, is_written); !missing.empty())
            verdict = check::Judgement{check::Outcome::waiting, check::waits_text(missing, "written")};
    }
    return by_check;
}

}  // namespace

TaskMark empty_mark(const TaskInfo& task) {
    return {.id = task.id, .title = task.title, .file = task.file, .of = task.points};
}

double LabMark::points() const {
    double sum = 0;
    for (const TaskMark& task : tasks) sum += task.points;
    return sum;
}
int LabMark::max_points() const {
    int sum = 0;
    for (const TaskMark& task : tasks) sum += task.of;
    return sum;
}
bool LabMark::graded() const {
    for (const TaskMark& task : tasks)
        for (const CheckMark& check : task.checks)
            if (check.outcome == check::Outcome::machine) return false;
    return true;
}

/// The judgement of a check, and the view that it belongs to.
struct LabGrader::Verdict {
    check::Judgement said;
    bool in_hidden_view = false;
    bool is_own = false;  ///< the check also fails with the solutions of all other tasks
};

LabGrader::LabGrader(const LabEntry& lab, const Stage& stage, GradeSetup setup)
    : views_(lab, stage, std::move(setup)),
      mistakes_(views_, views_.take_solution()),
      others_(lab, views_.manifest()) {}

LabGrader::Verdict LabGrader::judge_check(size_t check, const DrawnChecks& drawn) const {
    const check::Judgement own = views_.judge(views_.own(check, drawn));
    if (own.outcome != check::Outcome::passed || !views_.has_hidden(check)) return {own};
    const check::Judgement hidden = views_.judge(views_.hidden(check, drawn));
    if (hidden.outcome == check::Outcome::passed) return {own};
    return {{hidden.outcome, "correct in the check's own view; in a hidden one: " + hidden.found}, true};
}

/// Lets a mistake cost points only in its own task. A task is drawn again with the solutions of all other tasks if
/// another task loses points, too, or if a failed check depends on other tasks. A check that passes then has passed. If
/// the new attempt draws nothing, the first verdict stands.
void LabGrader::mark_tasks_alone(const Submission& submission, std::vector<Verdict>& verdicts,
                                 DrawnChecks& drawn) const {
    const std::vector<CheckInfo>& checks = manifest().checks;
    std::vector<bool> failed;
    std::set<std::string> losers;
    bool depends_on_others = false;
    for (size_t i = 0; i < checks.size(); ++i) {
        const check::Outcome outcome = verdicts[i].said.outcome;
        failed.push_back(outcome != check::Outcome::passed && outcome != check::Outcome::machine);
        if (!failed[i]) continue;
        losers.insert(checks[i].task);
        depends_on_others |= !checks[i].needs.empty() || !checks[i].leans_on.empty();
    }
    if (losers.size() < 2 && !depends_on_others) return;
    const CourseFiles solution = solution_files(manifest());
    for (const TaskInfo& task : manifest().tasks) {
        if (!task.alone || !losers.contains(task.id) || judge_file(task, submission, others_)) continue;
        CourseFiles files = solution;
        const auto transplanted = with_one_task(files[task.file], submission.files.at(task.file), task.id);
        if (!transplanted) continue;
        files[task.file] = *transplanted;
        std::vector<bool> wanted(checks.size());
        for (size_t i = 0; i < checks.size(); ++i) wanted[i] = failed[i] && checks[i].task == task.id;
        DrawnChecks alone = views_.draw(files, wanted, WhichViews::both);
        drawn.compile += alone.compile;
        drawn.draw += alone.draw;
        // Checks compare with each other. So all are judged before the loop below moves pictures out of `alone`.
        std::vector<size_t> decided;
        for (size_t i = 0; i < checks.size(); ++i) {
            if (!wanted[i]) continue;
            Verdict verdict = judge_check(i, alone);
            if (verdict.said.outcome == check::Outcome::passed)
                verdict.said.found = "passed with the solution of the other tasks";
            else if (verdict.said.outcome != check::Outcome::wrong)
                continue;
            else
                verdict.is_own = true;
            verdicts[i] = std::move(verdict);
            decided.push_back(i);
        }
        for (const size_t i : decided) drawn.checks[i] = std::move(alone.checks[i]);
    }
}

void LabGrader::keep_pictures(const Comparison& shown, bool is_hidden, std::vector<CheckPictures>& kept) const {
    const std::optional<Image>&drawn = shown.drawn.image, &expected = shown.expected();
    if (!drawn || !expected || !drawn->same_shape(*expected) || shown.check.shot.calls) return;
    CheckInfo check = shown.check;
    check.shot = shown.view.shot;
    kept.push_back({lab().folder, &manifest(), std::move(check), is_hidden, *drawn, *expected});
}

/// Returns how the picture of a check's own view relates to the expected one, in a sentence; or an empty text.
std::string LabGrader::relation_in(size_t check, const Comparison& shown) const {
    if (!shown.drawn.image || !shown.expected()) return {};
    const auto base = [&] {
        const std::lock_guard lock(base_mutex_);
        if (!bases_.contains(check)) bases_[check] = check::base_of(lab(), manifest(), manifest().checks[check]);
        return bases_.at(check);
    };
    const auto relation = check::relation_of(manifest(), shown.check, *shown.drawn.image, *shown.expected(), base);
    return relation ? relation->sentence : "";
}

/// Returns the marks of all tasks. `marks` is in the manifest's order of checks.
std::vector<TaskMark> LabGrader::task_marks(const std::vector<CheckMark>& marks) const {
    std::vector<TaskMark> tasks;
    for (const TaskInfo& info : manifest().tasks) {
        TaskMark& task = tasks.emplace_back(empty_mark(info));
        size_t passed = 0;
        for (size_t i = 0; i < marks.size(); ++i) {
            if (manifest().checks[i].task != info.id) continue;
            passed += marks[i].outcome == check::Outcome::passed;
            task.checks.push_back(marks[i]);
        }
        if (task.checks.empty())
            throw Error(fmt::format("labs/{}/lab.toml: task {} has no check", lab().folder, info.id));
        task.points = info.points * double(passed) / double(task.checks.size());
    }
    return tasks;
}

void LabGrader::name_mistakes(LabMark& lab, const DrawnChecks& drawn, const std::vector<Verdict>& verdicts,
                              const std::vector<check::TaskIds>& first, const std::vector<check::Judgement>& said,
                              const std::vector<bool>& is_drawn) const {
    std::vector<bool> compared;
    std::map<std::string, size_t> failures;  // by task: number of failures that it may have caused itself
    for (size_t i = 0; i < said.size(); ++i) {
        compared.push_back(verdicts[i].is_own || (is_drawn[i] && first[i].empty()));
        if (compared[i] && said[i].outcome != check::Outcome::passed) ++failures[manifest().checks[i].task];
    }
    for (TaskMark& task : lab.tasks) {
        if (!failures.contains(task.id)) continue;
        const std::optional<NamedMistake> named = mistakes_.name(task.id, drawn, compared);
        if (!named) continue;
        task.mistake = named->id;
        task.hint = check::told(named->hint, failures.at(task.id));
    }
}

check::Judgement LabGrader::words_of(const std::string& task, const CourseFiles& edited) const {
    const std::vector<CheckInfo>& checks = manifest().checks;
    const auto check = std::find_if(checks.begin(), checks.end(),
                                    [&](const CheckInfo& one) { return one.task == task && one.shot.calls; });
    CourseFiles files = edited;
    files.merge(solution_files(manifest()));  // keeps the edited files
    std::vector<bool> wanted(checks.size());
    wanted[size_t(check - checks.begin())] = true;
    return judge_check(size_t(check - checks.begin()), views_.draw(files, wanted, WhichViews::own)).said;
}

LabMark LabGrader::mark(const Submission& submission, std::vector<CheckPictures>* kept, bool with_names) const {
    const std::vector<CheckInfo>& checks = manifest().checks;
    const std::vector<std::optional<check::Judgement>> undrawable = judge_files(manifest(), submission, others_);
    std::vector<bool> is_drawn;
    for (const auto& why : undrawable) is_drawn.push_back(!why);
    CourseFiles files;
    for (const auto& [name, text] : submission.files)
        if (task_files(manifest()).contains(name)) files[name] = text;
    DrawnChecks drawn = views_.draw(files, is_drawn, WhichViews::both);

    const auto begin = Clock::now();
    std::vector<Verdict> verdicts;
    for (size_t i = 0; i < checks.size(); ++i)
        verdicts.push_back(undrawable[i] ? Verdict{*undrawable[i]} : judge_check(i, drawn));
    const double compared = seconds_since(begin);
    mark_tasks_alone(submission, verdicts, drawn);
    LabMark lab{.lab = this->lab().folder,
                .log = drawn.log,
                .times = {.compile = drawn.compile, .draw = drawn.draw, .compare = compared}};
    std::vector<check::Judgement> said;
    std::vector<CheckMark> marks;
    for (size_t i = 0; i < checks.size(); ++i) {
        const Verdict& verdict = verdicts[i];
        const Comparison shown = verdict.in_hidden_view ? views_.hidden(i, drawn) : views_.own(i, drawn);
        said.push_back(verdict.said);
        // A relation has numbers of the picture, and students do not see what a hidden check or view measures.
        if (with_names && verdict.said.outcome == check::Outcome::wrong && !verdict.in_hidden_view && !checks[i].hidden)
            said[i].relation = relation_in(i, shown);
        const std::string slow = views_.slowness(i, drawn);
        marks.push_back({.name = checks[i].name,
                         .outcome = verdict.said.outcome,
                         .found = verdict.said.found + (slow.empty() ? "" : "; " + slow),
                         .view = verdict.in_hidden_view ? view_text(shown.view.shot) : "",
                         .hidden = checks[i].hidden});
        if (kept && verdict.said.outcome != check::Outcome::passed) keep_pictures(shown, verdict.in_hidden_view, *kept);
    }
    const std::vector<check::TaskIds> first = check::put_right_first(manifest(), said);
    std::vector<check::TaskIds> first_of_mixed = first;  // a task alone among solutions waits for no other
    for (size_t i = 0; i < marks.size(); ++i)
        if (verdicts[i].is_own) first_of_mixed[i].clear();
    const std::vector<std::string> hints = check::hints(manifest(), said, first_of_mixed);
    for (size_t i = 0; i < marks.size(); ++i) marks[i].look_at = hints[i];
    lab.tasks = task_marks(marks);
    if (with_names && lab.graded()) name_mistakes(lab, drawn, verdicts, first, said, is_drawn);
    return lab;
}

}  // namespace relief::grade
