// The one judge of a lab: from the verdicts on its checks to the verdicts on its tasks, with points and hints.
// `relief check`, the window, the browser and the grader call it.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "framework/course/check/verdict.h"
#include "framework/course/task/rules.h"

namespace relief::check {

/// Where the text of the task files comes from: this course, or a submission.
struct TaskTexts {
    /// Returns the text of a task file; nothing if it is not there.
    std::function<std::optional<std::string>(const std::string& file)> read;
    /// Returns why a file that is there was refused, such as "is larger than 1 MiB"; empty if it was not.
    std::function<std::string(const std::string& file)> refused = {};
};

/// Returns why a check cannot be drawn, from the text of the task files alone: its file is missing or damaged, its task
/// lacks a function, is not written or reaches beyond its functions, or a task that it needs is not written. Nothing if
/// the check can be drawn.
std::optional<Verdict> judge_text(const Manifest& manifest, const CheckInfo& check, const TaskTexts& texts,
                                  const OtherShaders& others);

/// Says in a wrong verdict where the written task still calls unfinished().
void tell_leftover(const Manifest& manifest, const CheckInfo& check, const TaskTexts& texts, Verdict& said);

/// Returns the task that a compiler's message is about: the one whose missing function it names, or whose part of a
/// task file, as in "shaders/01_a/task.glsl:7: ...". Empty if it names none.
std::string culprit_of(const Manifest& manifest, const std::string& message, const TaskTexts& texts);

/// The tasks that made a check fail.
struct Cause {
    /// Wrong tasks other than the check's own, which should be put right first. The check says nothing about its own
    /// task yet.
    TaskIds first = {};
    /// Tasks of which at least one is wrong, and no check tells which: the check's own task is one of them. Else empty.
    TaskIds together = {};
};

/// Returns the cause of each failed check; an empty one for all other checks. Explains all failures by as few wrong
/// tasks as possible: each failed check belongs to a wrong task or depends on one. If several sets of this size explain
/// all, prefers more tasks that `is_recognised`, then fewer tasks whose checks without other tasks all pass. Tasks that
/// only some of the best sets have are undecided. `first` has no cycles: every chain of waiting checks ends at a failed
/// check that waits for no task. `checks` is in the manifest's order. `is_recognised`: whether the pictures of a task
/// show a known mistake; called only if several sets explain all.
std::vector<Cause> causes_of(const Manifest& manifest, const std::vector<Verdict>& checks,
                             const std::function<bool(const std::string& task)>& is_recognised = {});

/// A known mistake that the pictures of a task show.
struct NamedMistake {
    std::string id;    ///< empty in a student's course
    std::string hint;  ///< of this mistake, and of all mistakes that draw the same
    bool is_certain;   ///< see Agreement::is_certain()
};

/// Questions of the judge. An empty function: nobody can answer.
struct Evidence {
    /// Returns outcomes of the checks in `lost`, by task, when all tasks but the check's own have their solutions. Only
    /// the grader has solutions. A drawing beside solutions tells nothing else, because a submission could show them in
    /// it. A check that is missing keeps its verdict, as does one that neither passes nor is wrong. If the outcome is
    /// the same with and without the solutions, the check waits for no other task.
    std::function<std::map<size_t, Outcome>(const std::map<std::string, std::vector<size_t>>& lost)> among_solutions =
        {};
    /// Returns the known mistake that the task's pictures show. `compared`: for each check of the lab, whether its
    /// picture says something about its own task. No picture is drawn beside solutions.
    std::function<std::optional<NamedMistake>(const std::string& task, const std::vector<Verdict>& checks,
                                              const std::vector<bool>& compared)>
        recognise = {};
};

/// Returns the verdict on each task. `checks` has a verdict for each check, in the manifest's order.
///
/// A mistake costs points only in its own task. So if several tasks lose points, or a failed check depends on other
/// tasks, the judge asks for these checks among the solutions. Without solutions, checks wait for the tasks in
/// Cause::first. Throws Error if a task has no check.
std::vector<TaskVerdict> judge_lab(const Manifest& manifest, std::vector<Verdict> checks,
                                   const Evidence& evidence = {});

/// Returns the hint of a failed check by itself: a fault that its measured values or its picture show, else the usual
/// cause that the manifest gives.
std::string hint_of(const CheckInfo& check, const Verdict& said);

}  // namespace relief::check
