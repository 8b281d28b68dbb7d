// A lab's checks: they compare what the course's task files draw with the exact values, the solution, or another check.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"

namespace relief {

/// `unfinished`: the task, or one that the check needs, still calls unfinished(). `broken`: it does not compile,
/// throws, or draws nothing. The last four occur only in a separate process. `machine`: the grader or the machine
/// failed; that costs the student nothing.
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
    std::string details = {};         ///< what a compiler says more than `found`, with its source lines, or empty
    Image drawn = {}, expected = {};  ///< the compared pictures; empty if nothing was compared
    std::string look_at = {};         ///< see Advice; only check_lab() fills it in
};

struct TaskResult {
    const TaskInfo* task;
    std::vector<CheckResult> checks;
    std::string mistake = {};  ///< see Advice; empty if none is known
    /// Each passed check earns an equal share of the task's points.
    double points() const;
};

/// "2", "1.5"
std::string points_text(double points);

/// "waits for task 1.2, which is not written yet": the tasks that the check needs and that are not written. Empty if
/// all are written.
std::string waits_for(const CheckInfo& check, const std::function<bool(const std::string& task)>& is_written);

/// For each failed check, another failed check that should be put right first, or nullptr. The other check's task, and
/// all tasks that it depends on, must be among the tasks that this check depends on. So the other check is about fewer
/// tasks, and hints never form a circle. If there are several, it is the one that depends on the fewest tasks. `said`
/// is in the manifest's order of checks.
std::vector<const CheckInfo*> put_right_first(const Manifest& manifest, const std::vector<Judgement>& said);

/// For each check, whether it failed and another task may be to blame: one that should be put right first, or one that
/// this check depends on and that has failed all its own checks, while this check's task passes a check that does
/// without it. What such a check drew tells nothing about a mistake in its own task.
std::vector<bool> blames_another(const Manifest& manifest, const std::vector<Judgement>& said);

/// The hint of each check for the student: the task to put right first (see put_right_first()), else the check's own
/// hint. Empty if the check passed, or if `found` says enough.
std::vector<std::string> hints(const Manifest& manifest, const std::vector<Judgement>& said);

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
    std::vector<std::string> look_at;             ///< by check: the hint of the known mistake, or see hints()
    std::map<std::string, std::string> mistakes;  ///< by task: the hint of the known mistake that its pictures show
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

/// Runs all checks of a lab, task by task, and names known mistakes. Throws Error if a task has no check.
std::vector<TaskResult> check_lab(const LabEntry& lab, const Manifest& manifest, const Expected& expected = {});

}  // namespace relief
