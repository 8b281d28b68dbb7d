// A lab's checks: they compare what the course's task files draw with the exact values, the solution, or another check.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"

namespace relief {

/// `waiting`: a task that the check depends on is not written, or is wrong, so the check says nothing about its own
/// task yet. `unfinished`: the task still calls unfinished(). `broken`: it does not compile, throws, or draws nothing.
/// The last four occur only in a separate process. `machine`: the grader or the machine failed; that costs the student
/// nothing. In the order in which a task's worst is shown.
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
    /// The task in whose part of its file a compiler found the error, which is alone to blame; else empty.
    std::string culprit = {};
    std::string look_at = {};  ///< a hint that follows from what was measured, in place of the check's own; or empty
};

struct CheckResult {
    const CheckInfo* check;
    Outcome outcome = Outcome::broken;
    std::string found = {};
    std::string details = {};         ///< what a compiler says more than `found`, with its source lines, or empty
    Image drawn = {}, expected = {};  ///< the compared pictures; empty if nothing was compared
    std::string look_at = {};         ///< see Advice; only check_lab() fills it in
    std::string culprit = {};         ///< see Judgement
    TaskIds waits_for = {};           ///< the tasks for which it waits; in the manifest's order
};

struct TaskResult {
    const TaskInfo* task;
    std::vector<CheckResult> checks;
    std::string mistake = {};  ///< see Advice; empty if none is known
    /// Each passed check earns an equal share of the task's points.
    double points() const;
    /// The share of the checks that wait: how many points are still open.
    double waiting_points() const;
};

/// "2", "1.5"
std::string points_text(double points);

/// "2.25 of 3 points", and "0.75 waiting for 1.2" if checks wait for other tasks.
std::string points_text(const TaskResult& result);

/// The tasks that the check needs and that are not written.
TaskIds missing_tasks(const CheckInfo& check, const std::function<bool(const std::string& task)>& is_written);
/// "waits for task 1.2, which is not written yet"; `state` is "written" or "right".
std::string waits_text(const TaskIds& tasks, const char* state);

/// For each failed check, the wrong tasks that should be put right first; empty for all other checks. Such a check says
/// nothing about its own task. The wrong tasks are the smallest set of tasks with failed checks that explains all
/// failures: each failed check is of one of them or depends on one. Of several such sets, that in which more tasks are
/// in `recognised`, then that which fails the larger share of its checks. Following the tasks that checks wait for ends
/// at a failed check that waits for none. `said` is in the manifest's order of checks; `recognised`: the tasks whose
/// pictures show a known mistake.
std::vector<TaskIds> put_right_first(const Manifest& manifest, const std::vector<Judgement>& said,
                                     const std::set<std::string>& recognised = {});

/// The hint of each check for the student: the tasks to put right first (`first`, see put_right_first()), else the
/// check's own hint. Empty if the check passed, or if `found` says enough.
std::vector<std::string> hints(const Manifest& manifest, const std::vector<Judgement>& said,
                               const std::vector<TaskIds>& first);

/// The picture that a check compares with: the file in the lab's folder `expected`, if a handout put it there; else the
/// exact values, or what this course's files draw. Nothing for a check that compares with another check. Drawing needs
/// a context.
std::optional<Image> expectation(const LabEntry& lab, const CheckInfo& check);
/// The path of that file; it may not exist.
std::filesystem::path expectation_file(const LabEntry& lab, const CheckInfo& check);

/// Judges a picture: first whether it is usable at all, then its distance from the expected one. `drawn` need not be
/// trusted. Needs no context.
Judgement judge(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected);

/// Draws and compares in the current context. Never throws because of what a student's file does.
CheckResult run_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                      const std::optional<Image>& expected);

/// What all results together say.
struct Advice {
    std::vector<TaskIds> first;                   ///< by check: see put_right_first()
    std::vector<std::string> look_at;             ///< by check: the hint of the known mistake, or see hints()
    std::map<std::string, std::string> mistakes;  ///< by task: the hint of the known mistake that its pictures show

    /// Completes the result of a check: it waits for tasks that should be put right first, or has a hint.
    void apply(size_t check, CheckResult& result) const;
};

/// Runs a lab's checks one at a time, in any order and each as often as wanted. Task files are read at each run; the
/// lab's other shaders and its fingerprints once (no known mistakes if their file is damaged). The manifest must live
/// as long.
class LabChecker {
public:
    LabChecker(const LabEntry& lab, const Manifest& manifest);
    ~LabChecker();

    /// As run_check(), but a shader that reaches_beyond() its task is broken.
    CheckResult run(size_t check, const std::optional<Image>& expected);
    /// Of the last run of each check. One that never ran counts as broken.
    Advice advice() const;

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

/// What a check compares with; see expectation(), which is used where this is empty.
using Expected = std::function<std::optional<Image>(const CheckInfo& check)>;

/// Runs all checks of a lab, task by task, and names known mistakes. `begins` is called before each check. Throws Error
/// if a task has no check.
std::vector<TaskResult> check_lab(const LabEntry& lab, const Manifest& manifest, const Expected& expected = {},
                                  const std::function<void(const CheckInfo& check)>& begins = {});

}  // namespace relief
