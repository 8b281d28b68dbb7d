// The result of a check, of a task and of a lab: messages for a student, and the points.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/core/image/image.h"
#include "framework/course/manifest/manifest.h"

namespace relief::check {

/// The outcome of a check, from best to worst; a task shows its worst. `unproven`: would pass, but both pictures were
/// drawn by the files under test, see is_compared_with_itself(). `waiting`: a task that the check depends on is
/// not written or wrong, so the check says nothing about its own task yet. `unfinished`: the task still calls
/// unfinished(). `broken`: the task does not compile, throws, or draws nothing. The last four occur only in a separate
/// process. `machine`: the grader or the machine failed; the student loses no points.
enum class Outcome {
    passed,
    unproven,
    waiting,
    wrong,
    unfinished,
    broken,
    crashed,
    out_of_time,
    out_of_memory,
    machine
};
const char* name_of(Outcome outcome);
/// Throws Error for an unknown word.
Outcome outcome_of(const std::string& name);
/// Returns whether the check was made, and its task did not pass it.
bool has_failed(Outcome outcome);

/// The ids of tasks.
using TaskIds = std::vector<std::string>;

/// The verdict on a check. It outlives the manifest: the grader writes it, and reads it in a later run.
struct Verdict {
    Outcome outcome = Outcome::broken;
    std::string found = {};  ///< the measured and the allowed value, or the error in one line
    /// The task whose part of a file holds the compiler's error; no other task can be the cause. Else empty.
    std::string culprit = {};
    /// Before judge_lab(): a hint from the measured values, or empty. Afterwards: the whole hint for the student.
    std::string look_at = {};
    /// How the picture differs from the expected one, see relation_of(); or empty.
    std::string relation = {};
    /// The maximum over all limits of value / upper bound and of lower bound / value; at most 1 if the check passed.
    double used = 0;
    std::string details = {};         ///< the compiler's message beyond `found`, with its source lines, or empty
    TaskIds waits_for = {};           ///< the tasks that the check waits for, in the manifest's order
    bool is_own = false;              ///< the check also fails with the solutions of all other tasks
    std::string view = {};            ///< the hidden view, if the check failed only there; never shown to students
    size_t index = 0;                 ///< the check's, in the manifest's order
    std::string name = {};            ///< the check's
    bool hidden = false;              ///< the check is hidden from students
    bool of_words = false;            ///< the check calls functions, for the words of the task's text
    Image drawn = {}, expected = {};  ///< the compared pictures; empty if nothing was compared, or nobody asked
    Image related = {};               ///< see Relation::predicted; empty unless the hint tells the relation
};

/// The verdict on a task.
struct TaskVerdict {
    std::string id, title, file;
    int of = 0;             ///< maximum number of points
    bool optional = false;  ///< see TaskInfo::optional
    std::vector<Verdict> checks = {};
    /// The known mistake that its pictures show: its id, which a student's course does not know, and its hint. Else
    /// empty.
    std::string mistake = {}, hint = {};
    /// In a student's course: see HiddenChecks.
    int hidden_checks = 0;
    std::vector<std::string> not_tested = {};

    /// Returns the earned points. Each passed check earns an equal share. The checks of the task's words earn one share
    /// together, if all of them pass: a demand with public and hidden calls costs one share.
    double points() const;
    /// Returns the points that are still open: of the checks that wait or are unproven.
    double waiting_points() const;
    /// Returns the worst outcome of its checks.
    Outcome worst() const;
    /// Returns the points of one of its checks; they add up to points(), and `of` to the task's.
    struct Share {
        double points, of;
    };
    Share share_of(const Verdict& check) const;
};
/// Returns the verdict on a task before any check: no points.
TaskVerdict unjudged(const TaskInfo& task);

/// Points of several tasks.
struct PointSum {
    double points = 0, waiting = 0;
    int of = 0;
};
/// Returns the sum of the tasks that are optional, or of those that are not.
PointSum sum_of(const std::vector<TaskVerdict>& tasks, bool optional = false);

/// Returns points with at most two decimals: "2", "1.33".
std::string points_text(double points);

/// "2.25 of 3 points". A range if checks wait for other tasks: "1.5 to 3 of 3 points: 1.5 wait for 1.2"; or if they
/// are unproven: "1.5 to 3 of 3 points".
std::string points_text(const TaskVerdict& task);

/// Returns the points of a whole lab: "4.25 of 5 points", with optional tasks "4.25 of 5 points, and 2 of 4 optional
/// points", or "4.25 to 5 of 5 points" if points are still open. In a
/// student's course: "5 of 5 public points; 3 more checks decide the rest when it is graded".
std::string points_text(const std::vector<TaskVerdict>& tasks);

/// Returns why nothing is known about a check: it waits for another task, or a compiler's message keeps it from
/// drawing. Empty for all others. Reports put these checks behind one line, and the message before all tasks.
std::string reason_to_wait(const Verdict& result);
/// Checks of a task that wait for one reason.
struct WaitingChecks {
    std::string reason;
    std::vector<size_t> checks = {};
};
/// Groups the checks that have a reason_to_wait() by this reason, in the order of each group's first check. `results`:
/// one of each check of a task, null for a check that has not run; the groups hold their indices.
std::vector<WaitingChecks> waiting_checks(std::span<const Verdict* const> results);
std::vector<WaitingChecks> waiting_checks(const TaskVerdict& task);
/// "1 check", "5 checks"
std::string count_of_checks(size_t count);

/// "waits for task 1.2, which is not written yet"; `state` is "written" or "right".
std::string waits_text(const TaskIds& tasks, const char* state);

}  // namespace relief::check
