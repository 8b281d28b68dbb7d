// How a mark comes about: a submission's pictures, drawn in the sandbox, against the truth or what the solution draws
// there.
#pragma once

#include <string>
#include <vector>

#include "framework/staff/grade/check_views.h"
#include "framework/staff/grade/mistake_names.h"
#include "framework/staff/grade/submission.h"

namespace relief {

struct CheckMark {
    std::string name;
    Outcome outcome = Outcome::machine;
    std::string found;         ///< what was measured, or what went wrong
    std::string look_at = {};  ///< what to look at next; empty when it passed
    std::string view = {};     ///< the hidden view in which it did not pass, when it is that; never for students
    bool hidden = false;
};

struct TaskMark {
    std::string id, title, file;
    int of = 0;         ///< points
    double points = 0;  ///< in equal shares for its checks
    std::vector<CheckMark> checks = {};
    std::string mistake = {}, hint = {};  ///< of the known mistake that its pictures show, or empty
};
/// The mark of a task without checks and points.
TaskMark empty_mark(const TaskInfo& task);

/// What a check that did not pass has compared: both are there, of one shape. `drawn` is as it came from the
/// submission.
struct CheckPictures {
    std::string lab;  ///< folder
    const Manifest* manifest;
    CheckInfo check;           ///< with the shot that was drawn
    bool hidden_view = false;  ///< that shot is not the manifest's
    Image drawn, expected;
};

/// Seconds; those of several processes are added up.
struct MarkTimes {
    double compile = 0, draw = 0, compare = 0;
    double sum() const { return compile + draw + compare; }
    void add(const MarkTimes& more) {
        compile += more.compile;
        draw += more.draw;
        compare += more.compare;
    }
};

struct LabMark {
    std::string lab;  ///< folder
    std::vector<TaskMark> tasks = {};
    std::string log = {};  ///< the compiler's messages, or empty
    MarkTimes times = {};

    double points() const;
    int max_points() const;
    bool graded() const;  ///< no check failed through the grader's fault
};

/// Grades one lab: the solution is drawn once, then many threads may grade submissions.
class LabGrader {
public:
    /// Throws Error if the solution does not get all points on this machine; see LabViews.
    LabGrader(const LabEntry& lab, const Stage& stage, GradeSetup setup);

    const LabEntry& lab() const { return views_.lab(); }
    const Manifest& manifest() const { return views_.manifest(); }
    /// Number of checks that have a hidden view.
    size_t hidden_views() const { return views_.hidden_count(); }

    /// Adds to `pictures` what failed checks compared; their manifest pointer is this grader's.
    LabMark mark(const Submission& submission, std::vector<CheckPictures>* pictures = nullptr,
                 bool with_names = true) const;

private:
    struct Verdict;
    Verdict judge_check(size_t check, const DrawnChecks& drawn) const;
    void keep_pictures(const Comparison& shown, bool is_hidden, std::vector<CheckPictures>& kept) const;
    std::vector<TaskMark> task_marks(const std::vector<CheckMark>& marks) const;
    void name_mistakes(LabMark& lab, const DrawnChecks& drawn, const std::vector<Judgement>& said,
                       const std::vector<bool>& is_drawn) const;

    LabViews views_;
    MistakeNames mistakes_;
};

}  // namespace relief
