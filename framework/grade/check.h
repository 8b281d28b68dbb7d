// A lab's checks: what the course's own files draw, held against the truth, the solution, or another picture.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"

namespace relief {

/// `unfinished`: the task, or one that the check needs, still calls unfinished(). `broken`: it does not compile,
/// throws, or draws nothing. The rest can only be said of a process of its own; `machine`: the grader or the machine
/// failed, and a student loses nothing by it.
enum class Outcome { passed, wrong, unfinished, broken, crashed, out_of_time, out_of_memory, machine };
const char* name_of(Outcome outcome);
/// Throws Error for another word.
Outcome outcome_of(const std::string& name);

/// What a check says.
struct Judgement {
    Outcome outcome = Outcome::broken;
    std::string found = {};  ///< what was measured and what is allowed, or what went wrong
};

struct CheckResult {
    const CheckInfo* check;
    Outcome outcome = Outcome::broken;
    std::string found = {};
    Image drawn = {}, expected = {};  ///< what was compared; empty where it did not come to that
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

/// For each check that has failed, the one to be put right first: one that has failed too and is about other tasks and
/// nothing else, its task, with all that it depends on, being among what this one depends on. Else nothing. It is about
/// fewer tasks each time, so nobody is sent in a circle. `said` is by check of the manifest.
std::vector<const CheckInfo*> put_right_first(const Manifest& manifest, const std::vector<Judgement>& said);

/// What a student looks at next, check by check; empty where nothing is wrong or the finding says it all. The task that
/// comes first, see above, else the check's own hint.
std::vector<std::string> hints(const Manifest& manifest, const std::vector<Judgement>& said);

/// What a check compares with, from the lab's folder `expected` where a handout has left it, else the truth or the
/// solution of this course itself. Nothing for a check against another. Wants a context for a solution.
std::optional<Image> expectation(const LabEntry& lab, const CheckInfo& check);
/// The file of it, whether it is there or not.
std::filesystem::path expectation_file(const LabEntry& lab, const CheckInfo& check);

/// What is said of a picture, whoever has drawn it: first whether it is one at all, then how far it is from what is
/// expected. `drawn` need not be trusted. Wants no context.
Judgement judge(const Manifest& manifest, const CheckInfo& check, const Image& drawn, const Image& expected);

/// Draws and compares, in the current context. Never throws for what a student's file does.
CheckResult run_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                      const std::optional<Image>& expected);

/// All checks of a lab, task by task. Throws Error when a task has none: then nothing would be looked at.
std::vector<TaskResult> check_lab(const LabEntry& lab, const Manifest& manifest);

}  // namespace relief
