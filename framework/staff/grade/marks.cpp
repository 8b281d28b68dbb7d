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
#include "framework/staff/grade/transplant.h"
#include "framework/staff/grade/variation.h"

namespace relief::grade {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Returns the texts of a submission's task files.
check::TaskTexts texts_of(const Submission& submission) {
    const auto value_of = [](const std::map<std::string, std::string>& all, const std::string& file) {
        const auto found = all.find(file);
        return found == all.end() ? std::nullopt : std::optional(found->second);
    };
    return {
        .read = [&, value_of](const std::string& file) { return value_of(submission.files, file); },
        .refused = [&, value_of](const std::string& file) { return value_of(submission.refused, file).value_or(""); }};
}

}  // namespace

double LabMark::points() const {
    const check::PointSum sum = check::sum_of(tasks), optional = check::sum_of(tasks, true);
    return std::min(sum.points + optional.points, double(sum.of));
}
int LabMark::max_points() const { return check::sum_of(tasks).of; }
bool LabMark::graded() const {
    for (const check::TaskVerdict& task : tasks)
        for (const check::Verdict& check : task.checks)
            if (check.outcome == check::Outcome::machine) return false;
    return true;
}

LabGrader::LabGrader(const LabEntry& lab, const Stage& stage, GradeSetup setup)
    : views_(lab, stage, std::move(setup)),
      mistakes_(views_, views_.take_solution()),
      others_(lab, views_.manifest()) {}

check::Verdict LabGrader::judge_check(size_t check, const DrawnChecks& drawn) const {
    const check::Verdict own = views_.judge(views_.own(check, drawn));
    if (own.outcome != check::Outcome::passed || !views_.has_hidden(check)) return own;
    const Comparison comparison = views_.hidden(check, drawn);
    check::Verdict hidden = views_.judge(comparison);
    if (hidden.outcome == check::Outcome::passed) return own;
    hidden.found = "correct in the check's own view; in a hidden one: " + hidden.found;
    hidden.view = view_text(comparison.view.shot);
    return hidden;
}

/// Returns whether the time ran out while a check of this task was drawn.
bool LabGrader::ran_out(const std::string& task, const DrawnChecks& drawn) const {
    for (size_t i = 0; i < drawn.checks.size(); ++i)
        if (manifest().checks[i].task == task && (drawn.checks[i].own.ran_out || drawn.checks[i].hidden.ran_out))
            return true;
    return false;
}

/// Judges lost checks among the solutions, within the time that a submission may take. A task whose check ran out of
/// time would do so again, unless another task is the cause. So it comes last, and only if another one ran out, too.
/// All drawings that are out of time may together take two limits of wall time.
std::map<size_t, check::Outcome> LabGrader::judge_each_alone(const Submission& submission,
                                                             const std::map<std::string, std::vector<size_t>>& lost,
                                                             DrawnChecks& drawn) const {
    constexpr double most_wasted = 2;
    std::map<size_t, check::Outcome> outcomes;
    if (drawn.compiles_forever) return outcomes;
    const double wasted = drawn.wasted;
    for (const bool last : {false, true})
        for (const auto& [task, checks] : lost)
            if (ran_out(task, drawn) == last && (!last || drawn.wasted > wasted) && drawn.wasted < most_wasted)
                outcomes.merge(judge_alone(submission, task, checks, drawn));
    return outcomes;
}

/// Returns whether one of the checks depends on a task in a shader.
bool LabGrader::depend_on_shaders(const std::vector<size_t>& checks) const {
    return std::any_of(checks.begin(), checks.end(), [&](size_t i) {
        const CheckInfo& check = manifest().checks[i];
        const auto is_in_shader = [&](const std::string& task) { return is_shader(manifest().task(task).file); };
        return std::any_of(check.needs.begin(), check.needs.end(), is_in_shader) ||
               std::any_of(check.leans_on.begin(), check.leans_on.end(), is_in_shader);
    });
}

/// Judges some checks of a task among the solutions of all other tasks. Returns nothing if the task cannot be put
/// there. The outcomes are all that leaves the drawing: a student's C++ can show whatever its process can read.
std::map<size_t, check::Outcome> LabGrader::judge_alone(const Submission& submission, const std::string& task,
                                                        const std::vector<size_t>& lost, DrawnChecks& drawn) const {
    const std::string& file = manifest().task(task).file;
    if (const auto why = check::judge_text(manifest(), manifest().checks[lost.front()], texts_of(submission), others_);
        why && why->outcome != check::Outcome::waiting)
        return {};
    CourseFiles files = solution_files(manifest());
    const bool is_program = !is_shader(file);
    const auto transplanted = with_one_task(is_program ? "" : files[file], submission.files.at(file), manifest().tasks,
                                            manifest().task(task));
    if (!transplanted) return {};
    if (is_program) {
        const bool has_shaders = depend_on_shaders(lost);
        std::erase_if(files, [&](const auto& one) { return !has_shaders || !is_shader(one.first); });
    }
    files[file] = *transplanted;
    std::vector<bool> wanted(manifest().checks.size());
    for (const size_t i : lost) wanted[i] = true;
    const DrawnChecks alone = views_.draw(files, wanted, WhichViews::both, is_program ? task : "");
    drawn.compile += alone.compile;
    drawn.draw += alone.draw;
    drawn.wasted += alone.wasted;
    std::map<size_t, check::Outcome> outcomes;
    for (const size_t i : lost) outcomes[i] = judge_check(i, alone).outcome;
    return outcomes;
}

void LabGrader::keep_pictures(const Comparison& shown, bool is_hidden, std::vector<CheckPictures>& kept) const {
    const std::optional<Image>&drawn = shown.drawn.image, &expected = shown.expected();
    if (!drawn || !expected || !drawn->same_shape(*expected) || shown.check.shot.calls) return;
    CheckInfo check = shown.check;
    check.shot = shown.view.shot;
    kept.push_back({lab().folder, &manifest(), std::move(check), is_hidden, *drawn, *expected});
}

/// Adds how the picture of a check's own view relates to the expected one.
void LabGrader::add_relation(size_t check, const DrawnChecks& drawn, check::Verdict& said) const {
    // A relation has numbers of the picture, and students do not see what a hidden check or view measures.
    if (said.outcome != check::Outcome::wrong || !said.view.empty() || manifest().checks[check].hidden) return;
    const Comparison shown = views_.own(check, drawn);
    if (!shown.drawn.image || !shown.expected()) return;
    const auto base = [&] {
        const std::lock_guard lock(base_mutex_);
        if (!bases_.contains(check)) bases_[check] = check::base_of(lab(), manifest(), manifest().checks[check]);
        return bases_.at(check);
    };
    if (const auto relation = check::relation_of(manifest(), shown.check, *shown.drawn.image, *shown.expected(), base))
        said.relation = relation->sentence;
}

check::Verdict LabGrader::words_of(const ExampleInfo& example, const CourseFiles& edited) const {
    const std::vector<CheckInfo>& checks = manifest().checks;
    const auto check = std::find_if(checks.begin(), checks.end(), [&](const CheckInfo& one) {
        return one.task == example.task && one.hidden == example.hidden && one.shot.calls;
    });
    CourseFiles files = edited;
    files.merge(solution_files(manifest()));  // keeps the edited files
    std::vector<bool> wanted(checks.size());
    wanted[size_t(check - checks.begin())] = true;
    return judge_check(size_t(check - checks.begin()), views_.draw(files, wanted, WhichViews::own));
}

LabMark LabGrader::mark(const Submission& submission, std::vector<CheckPictures>* kept, bool with_names) const {
    const std::vector<CheckInfo>& checks = manifest().checks;
    const check::TaskTexts texts = texts_of(submission);
    std::vector<std::optional<check::Verdict>> undrawable;
    std::vector<bool> is_drawn;
    for (const CheckInfo& check : checks) {
        std::optional<check::Verdict>& why =
            undrawable.emplace_back(check::judge_text(manifest(), check, texts, others_));
        if (why) why->found = printable(why->found, 400), why->details = printable_lines(why->details, 4000);
        is_drawn.push_back(!undrawable.back());
    }
    CourseFiles files;
    for (const auto& [name, text] : submission.files)
        if (task_files(manifest()).contains(name)) files[name] = text;
    DrawnChecks drawn = views_.draw(files, is_drawn, WhichViews::both);

    const auto begin = Clock::now();
    std::vector<check::Verdict> verdicts;
    for (size_t i = 0; i < checks.size(); ++i) {
        check::Verdict& said = verdicts.emplace_back(undrawable[i] ? *undrawable[i] : judge_check(i, drawn));
        if (said.outcome == check::Outcome::broken && said.culprit.empty())
            said.culprit = check::culprit_of(manifest(), said.found, texts);
        check::tell_leftover(manifest(), checks[i], texts, said);
        if (with_names) add_relation(i, drawn, said);
    }
    LabMark lab{.lab = this->lab().folder,
                .times = {.compile = drawn.compile, .draw = drawn.draw, .compare = seconds_since(begin)}};
    check::Evidence evidence;
    evidence.among_solutions = [&](const std::map<std::string, std::vector<size_t>>& lost) {
        return judge_each_alone(submission, lost, drawn);
    };
    if (with_names)
        evidence.recognise = [&](const std::string& task, const std::vector<check::Verdict>& said,
                                 std::vector<bool> compared) {
            for (size_t i = 0; i < compared.size(); ++i) compared[i] = compared[i] && is_drawn[i];
            return mistakes_.name(task, said, drawn, compared);
        };
    lab.tasks = check::judge_lab(manifest(), std::move(verdicts), evidence);
    lab.times.compile = drawn.compile, lab.times.draw = drawn.draw;
    lab.log = drawn.log;
    for (check::TaskVerdict& task : lab.tasks)
        for (check::Verdict& said : task.checks) {
            if (const std::string slow = views_.slowness(said.index, drawn); !slow.empty()) said.found += "; " + slow;
            if (!kept || said.outcome == check::Outcome::passed) continue;
            const bool is_hidden = !said.view.empty();
            keep_pictures(is_hidden ? views_.hidden(said.index, drawn) : views_.own(said.index, drawn), is_hidden,
                          *kept);
        }
    return lab;
}

}  // namespace relief::grade
