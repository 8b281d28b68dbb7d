// The views of a lab's checks: a check's own shot and, with a seed, a hidden one that students do not know.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/staff/grade/attempt.h"

namespace relief::grade {

/// How submissions are drawn.
struct GradeSetup {
    Isolation isolation = Isolation::namespaces;
    /// Limit of processor time for drawing a lab once, in seconds. All its processes together have twice that, the
    /// compiler three times. 0: ten times the solution's processor time, but at least 10 seconds.
    double seconds = 0;
    size_t memory = size_t{2} << 30;  ///< bytes of address space
    std::string seed = {};            ///< seed of the hidden views; empty: no hidden views
    check::Renderer renderer = {};
};

struct View {
    Shot shot;
    std::optional<Image> expected = {};  ///< empty if the check compares with another check
    double solution_cpu = 0;             ///< the solution's processor time in seconds
};

/// Returns "it takes 34 times the processor time of the solution, 6.9 seconds" for more than 20 times; else empty. Both
/// arguments are in seconds. A smaller `solution_cpu` counts as 0.05, because the first picture of a process takes 0.05
/// seconds more than later ones.
std::string slowness(double cpu, double solution_cpu);

struct CheckViews {
    View own;
    std::optional<View> hidden = {};
};

/// The drawn views of one check. A view that was not requested stays empty.
struct DrawnViews {
    DrawnAttempt own, hidden;
};

struct DrawnChecks {
    std::vector<DrawnViews> checks = {};   ///< in the manifest's order
    double compile = 0, draw = 0;          ///< seconds
    double wasted = 0;                     ///< see Attempt
    bool compiles_forever = false;         ///< see Attempt
    double cpu = 0;                        ///< seconds of processor time for drawing, see Attempt
    std::string log = {};                  ///< the compiler's messages, or empty
    check::CompiledShaders compiled = {};  ///< see Attempt
};

/// The two sides of a check's comparison in one view. `other_shot` and `other` belong to the check named by
/// `check.against`. If that names no check, they are the view's own.
struct Comparison {
    const CheckInfo& check;
    const View& view;
    const DrawnAttempt& drawn;
    const Shot& other_shot;
    const DrawnAttempt& other;

    const std::optional<Image>& expected() const { return view.expected ? view.expected : other.image; }
};

enum class WhichViews { own, hidden, both };

/// Draws and judges the checks of one lab. Its const functions are thread-safe.
class LabViews {
public:
    /// Draws the solution in the sandbox. Throws Error if the lab has no checks, or if its solution fails one, because
    /// then no mark on this machine can be trusted. A check gets no hidden view if the solution fails there.
    LabViews(const LabEntry& lab, const Stage& stage, GradeSetup setup);

    const LabEntry& lab() const { return lab_; }
    const Manifest& manifest() const { return manifest_; }
    bool has_hidden(size_t check) const { return views_[check].hidden.has_value(); }
    size_t hidden_count() const;
    /// Returns the solution's processor time on this machine in seconds, hidden views included.
    double solution_cpu() const { return solution_cpu_; }
    /// Derives the limit from `solution_cpu` seconds, such as another machine's measurement. Does nothing if the setup
    /// has a limit. Throws Error if this machine is so slow that the solution exceeds the derived limit.
    void bound_by(double solution_cpu);
    /// Finds the compiled shaders that do not depend on the task files, once for all later calls of draw(). Draws all
    /// views once more, so it pays from a few submissions on. The pictures have the same bits.
    void reuse_shaders();
    const check::CompiledShaders& reused_shaders() const { return shared_; }
    /// Moves out the solution's pictures in the checks' own views. Call it at most once.
    DrawnChecks take_solution() { return std::move(solution_); }

    /// Draws the checks that are true in `checks`, and the checks that they compare with. For C++ tasks, separate
    /// processes draw public and hidden pictures; see attempt(). `alone`: see Stage::course().
    DrawnChecks draw(const CourseFiles& files, const std::vector<bool>& checks, WhichViews which,
                     const std::string& alone = {}) const;

    Comparison own(size_t check, const DrawnChecks& drawn) const;
    /// Precondition: the check has a hidden view.
    Comparison hidden(size_t check, const DrawnChecks& drawn) const;
    check::Verdict judge(const Comparison& comparison) const;
    /// Returns slowness() of the check's own view; if that is empty, of its hidden view.
    std::string slowness(size_t check, const DrawnChecks& drawn) const;

private:
    DrawnChecks draw(const CourseFiles& files, const std::vector<bool>& checks, WhichViews which,
                     const std::string& alone, bool keeps_compiled) const;
    size_t compared_with(size_t check) const;
    std::vector<bool> with_compared(std::vector<bool> checks) const;
    double find_hidden_views(const CourseFiles& solution);
    void keep_passing_views(const DrawnChecks& solution);

    const LabEntry& lab_;
    const Stage& stage_;
    GradeSetup setup_;
    Manifest manifest_;
    std::vector<CheckViews> views_;  ///< in the manifest's order
    DrawnChecks solution_;
    check::CompiledShaders compiled_;  ///< the solution's
    check::CompiledShaders shared_;    ///< see reuse_shaders()
    double solution_cpu_ = 0;
    bool derives_limit_;
};

}  // namespace relief::grade
