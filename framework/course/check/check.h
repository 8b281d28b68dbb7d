// Runs a lab's checks: draws with the course's task files, and judges the pictures.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/check/agreement.h"
#include "framework/course/check/allowance.h"
#include "framework/course/check/comparison.h"
#include "framework/course/check/expectation.h"
#include "framework/course/check/judge.h"

namespace relief::check {

/// Draws and compares in the current context. An Error from a student's file becomes a verdict, not an exception.
Verdict run_check(const LabEntry& lab, const Manifest& manifest, const CheckInfo& check,
                  const std::optional<Image>& expected);

/// Returns the current context's renderer. It has no name without a context, which counts as an unknown GPU.
NamedRenderer renderer_of_context();

/// The result of a check's run: the verdict, and the picture's values by which known mistakes are recognised; nothing
/// if there are none, or if nothing was drawn.
struct CheckResult {
    Verdict said = {};
    std::optional<Sample> sample = {};
};

/// Runs a lab's checks one at a time, in any order and any number of times. Reads the task files at each run; reads the
/// lab's other shaders and its fingerprints once. Knows no mistakes if the file of fingerprints is damaged. The
/// manifest must outlive the checker.
class LabChecker {
public:
    /// `renderer` draws, see with_allowance(). Default: that of the current context.
    LabChecker(const LabEntry& lab, const Manifest& manifest, const NamedRenderer& renderer = renderer_of_context());
    ~LabChecker();

    /// Runs a check, and keeps its verdict for tasks(). `expected`: the picture to compare with; if there is none, the
    /// check compares with another check.
    const Verdict& run(size_t check, const std::optional<Image>& expected);
    /// Draws with a kept lab. No file of it may have changed since it was made.
    const Verdict& run(size_t check, const std::optional<Image>& expected, KeptLab& kept);
    /// Returns the result of a check's last run, and forgets it.
    CheckResult take_result(size_t check);
    /// Keeps the result of a run, here or in another process.
    void keep(size_t check, CheckResult result);
    void set_renderer(const NamedRenderer& renderer);
    /// Returns the judge's verdict on all tasks, from the last run of each check. A check that never ran is unfinished.
    std::vector<TaskVerdict> tasks() const;

private:
    struct Memory;
    std::unique_ptr<Memory> memory_;
};

/// Returns the manifest of a lab without the hidden checks against the solution that have no expectation_file(). In the
/// staff's course the solution is in the task files under test, so only the grader, which draws it separately, can
/// compare with it.
Manifest manifest_to_check(const LabEntry& lab);

/// Returns the indices of a manifest's checks in the order in which they run: calls first, which take little time
/// even in a task that does not end, then the other checks of each task.
std::vector<size_t> checks_in_order(const Manifest& manifest);

/// Returns the picture that a check compares with, see expectation(). Nothing if the solution, which it compares with,
/// cannot be drawn: in the staff's course, the check itself says why. Throws Error if other files are missing or
/// damaged.
std::optional<Image> expected_of(KeptLab& kept, const CheckInfo& check);

}  // namespace relief::check
