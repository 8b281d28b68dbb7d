// A lab's checks: compare pictures drawn with the course's task files with exact values, the solution, or another
// check.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/core/lab/manifest.h"
#include "framework/course/check/allowance.h"
#include "framework/course/check/relation.h"

namespace relief::check {

class KeptLabs;

/// The outcome of a check, from best to worst; a task shows its worst. `waiting`: a task that the check depends on is
/// not written or wrong, so the check says nothing about its own task yet. `unfinished`: the task still calls
/// unfinished(). `broken`: the task does not compile, throws, or draws nothing. The last four occur only in a separate
/// process. `machine`: the grader or the machine failed; the student loses no points.
enum class Outcome { passed, waiting, wrong, unfinished, broken, crashed, out_of_time, out_of_memory, machine };
const char* name_of(Outcome outcome);
/// Throws Error for an unknown word.
Outcome outcome_of(const std::string& name);

/// The ids of tasks.
using TaskIds = std::vector<std::string>;

/// The result of a check.
struct Judgement {
    Outcome outcome = Outcome::broken;
    std::string found = {};  ///< the measured and the allowed value, or the error
    /// The task whose part of a file holds the compiler's error; no other task can be the cause. Else empty.
    std::string culprit = {};
    std::string look_at = {};  ///< a hint from the measured values, which replaces the check's own; or empty
    /// How the picture differs from the expected one, see relation_of(); or empty. judge() does not look for it.
    std::string relation = {};
    /// The maximum over all limits of value / upper bound and of lower bound / value; at most 1 if the check passed.
    double used = 0;
};

struct CheckResult {
    const CheckInfo* check;
    Outcome outcome = Outcome::broken;
    std::string found = {};
    std::string details = {};         ///< the compiler's message beyond `found`, with its source lines, or empty
    Image drawn = {}, expected = {};  ///< the compared pictures; empty if nothing was compared
    std::string look_at = {};         ///< see Advice; only check_lab() fills it in
    std::string culprit = {}, relation = {};  ///< see Judgement
    Image related = {};                       ///< see Relation::predicted; empty unless the hint tells the relation
    TaskIds waits_for = {};                   ///< the tasks that the check waits for, in the manifest's order
};

struct TaskResult {
    const TaskInfo* task;
    std::vector<CheckResult> checks;
    std::string mistake = {};  ///< see Advice; empty if no known mistake was found
    /// Returns the earned points. Each check is worth an equal share of the task's points.
    double points() const;
    /// Returns the points of the checks that wait.
    double waiting_points() const;
};

/// "2", "1.5"
std::string points_text(double points);

/// "2.25 of 3 points", and "0.75 waiting for 1.2" if checks wait for other tasks.
std::string points_text(const TaskResult& result);

/// Returns the points of a whole lab: "4.25 of 5 points", and ", 0.75 waiting" if checks wait for other tasks.
std::string points_text(const std::vector<TaskResult>& tasks);

/// The tasks that the check needs and that are not written.
TaskIds missing_tasks(const CheckInfo& check, const std::function<bool(const std::string& task)>& is_written);
/// "waits for task 1.2, which is not written yet"; `state` is "written" or "right".
std::string waits_text(const TaskIds& tasks, const char* state);

/// Returns for each failed check the wrong tasks that should be put right first; empty for all other checks. A check
/// with such tasks says nothing about its own task. The wrong tasks are the smallest set of tasks with failed checks
/// that explains all failures: each failed check belongs to a task of the set or depends on one. Among several such
/// sets, prefers more tasks in `recognised`, then a larger share of failed checks. The result has no cycles: every
/// chain of waiting checks ends at a failed check that waits for no task. `said` is in the manifest's order of checks.
/// `recognised`: the tasks whose pictures show a known mistake.
std::vector<TaskIds> put_right_first(const Manifest& manifest, const std::vector<Judgement>& said,
                                     const std::set<std::string>& recognised = {});

/// Returns the hint of a failed check: the hint of the judgement or of the check, then the relation of the two
/// pictures.
std::string hint_of(const CheckInfo& check, const Judgement& said);

/// Returns the hint of each check for the student: the tasks to put right first (`first`, see put_right_first()), else
/// hint_of() for a wrong check. Of a task's wrong checks only the first has the check's own hint: the hints of later
/// ones name details that the code may have right. Those keep the judgement's hint and the relation.
std::vector<std::string> hints(const Manifest& manifest, const std::vector<Judgement>& said,
                               const std::vector<TaskIds>& first);

/// Returns the picture that a check compares with. It is the file in the lab's folder `expected`, if a handout put it
/// there; else the exact values, or the picture that this course's files draw. Empty for a check that compares with
/// another check. Drawing needs a current context.
std::optional<Image> expectation(const LabEntry& lab, const CheckInfo& check);
std::optional<Image> expectation(KeptLabs& labs, const CheckInfo& check);
/// Returns the path of the file in `expected`; it may not exist.
std::filesystem::path expectation_file(const LabEntry& lab, const CheckInfo& check);

/// Returns the picture of a check's shot without relief, see ProbeInfo::without. It is the file in the lab's folder
/// `expected`, if a handout put it there; else the exact values. Empty if there is neither.
std::optional<Image> base_of(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check);
std::filesystem::path base_file(const LabEntry& lab, const CheckInfo& check);

/// Returns how a wrong picture relates to the expected one. Nothing if there is no simple relation, or if the picture
/// is better than the task asks for. Calls `base`, which returns base_of(), only if there is no relation without it.
std::optional<Relation> relation_of(const Manifest& manifest, const CheckInfo& check, const Image& drawn,
                                    const Image& expected, const std::function<std::optional<Image>()>& base);

/// Judges a picture: first whether it is usable, then its distance from the expected one. `drawn` may come from an
/// untrusted process: its shape and values are checked. Needs no context.
Judgement judge(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected);

/// Draws and compares in the current context. An Error from a student's file becomes a result, not an exception.
CheckResult run_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                      const std::optional<Image>& expected);

/// Advice that needs the results of all checks of a lab.
struct Advice {
    std::vector<TaskIds> first;                   ///< by check: see put_right_first()
    std::vector<std::string> look_at;             ///< by check: the hint of the known mistake, or see hints()
    std::map<std::string, std::string> mistakes;  ///< by task: the hint of the known mistake that its pictures show

    /// Completes the result of a check: adds its hint, or makes it wait for the tasks that should be put right first.
    void apply(size_t check, CheckResult& result) const;
};

/// Returns the current context's renderer. It has no name without a context, which counts as an unknown GPU.
NamedRenderer renderer_of_context();

/// Runs a lab's checks one at a time, in any order and any number of times. Reads the task files at each run; reads the
/// lab's other shaders and its fingerprints once. Knows no mistakes if the file of fingerprints is damaged. The
/// manifest must outlive the checker.
class LabChecker {
public:
    /// `renderer` draws, see with_allowance(). Default: that of the current context.
    LabChecker(const LabEntry& lab, const Manifest& manifest, const NamedRenderer& renderer = renderer_of_context());
    ~LabChecker();

    /// Like run_check(), but the outcome is `broken` if the task's shader reaches_beyond() its functions.
    CheckResult run(size_t check, const std::optional<Image>& expected);
    /// Draws with kept labs, which no file may have changed since they were made.
    CheckResult run(size_t check, const std::optional<Image>& expected, KeptLabs& labs);
    /// Returns advice from the last run of each check. A check that never ran counts as broken.
    Advice advice() const;

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

/// Returns the picture that a check compares with. If the function itself is empty, expectation() replaces it.
using Expected = std::function<std::optional<Image>(const CheckInfo& check)>;

/// Returns the manifest of a lab without the hidden checks against the solution that have no expectation_file(). In the
/// staff's course the solution is in the task files under test, so only the grader, which draws it separately, can
/// compare with it.
Manifest manifest_to_check(const LabEntry& lab);

/// Runs all checks of a lab, task by task, and names known mistakes. `begins` is called before each check. Throws Error
/// if a task has no check.
std::vector<TaskResult> check_lab(const LabEntry& lab, const Manifest& manifest, const Expected& expected = {},
                                  const std::function<void(const CheckInfo& check)>& begins = {});

}  // namespace relief::check
