// A lab's checks: compare what the course's own files draw with the exact values, the solution, or another picture.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"

namespace relief {

/// `unfinished`: the task, or one that the check needs, still calls unfinished(). `broken`: it does not compile,
/// throws, or draws nothing. The others apply only to a separate process; `machine`: the grader or the machine
/// failed, which costs the student nothing.
enum class Outcome { passed, wrong, unfinished, broken, crashed, out_of_time, out_of_memory, machine };
const char* name_of(Outcome outcome);
/// Throws Error for an unknown word.
Outcome outcome_of(const std::string& name);

/// The result of a check.
struct Judgement {
    Outcome outcome = Outcome::broken;
    std::string found = {};  ///< the measured and the allowed value, or the error
};

struct CheckResult {
    const CheckInfo* check;
    Outcome outcome = Outcome::broken;
    std::string found = {};
    Image drawn = {}, expected = {};  ///< the compared pictures; empty if nothing was compared
    std::string look_at = {};         ///< see hints(); check_lab() alone knows it
};

struct TaskResult {
    const TaskInfo* task;
    std::vector<CheckResult> checks;
    /// The task's points in equal shares for its checks.
    double points() const;
};

/// "2", "1.5"
std::string points_text(double points);

/// "waits for task 1.2, which is not written yet", of the tasks that a check needs; empty when all are written.
std::string waits_for(const CheckInfo& check, const std::function<bool(const std::string& task)>& is_written);

/// For each check that has failed, the one to put right first: one that has failed too, and whose task, with all that
/// it depends on, is among the tasks that this one depends on. Else nothing. It is about fewer tasks each time, so
/// hints never form a circle. `said` has the manifest's order of checks.
std::vector<const CheckInfo*> put_right_first(const Manifest& manifest, const std::vector<Judgement>& said);

/// The hint for a student, for each check; empty if nothing is wrong or the finding says it all. It names the task that
/// comes first, see above; else it is the check's own hint.
std::vector<std::string> hints(const Manifest& manifest, const std::vector<Judgement>& said);

/// The picture that a check compares with: from the lab's folder `expected` if a handout put it there, else the exact
/// values or the solution of this course. Nothing for a check against another check. A solution needs a context.
std::optional<Image> expectation(const LabEntry& lab, const CheckInfo& check);
/// The path of that file, whether it exists or not.
std::filesystem::path expectation_file(const LabEntry& lab, const CheckInfo& check);

/// Judges a picture, whoever drew it: first whether it is usable at all, then how far it is from the
/// expected one. `drawn` need not be trusted. Needs no context.
Judgement judge(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected);

/// Draws and compares, in the current context. Never throws for what a student's file does.
CheckResult run_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                      const std::optional<Image>& expected);

/// Runs all checks of a lab, task by task. Throws Error if a task has none.
std::vector<TaskResult> check_lab(const LabEntry& lab, const Manifest& manifest);

}  // namespace relief
