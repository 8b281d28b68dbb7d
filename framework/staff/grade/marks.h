// Marks: a submission is drawn in the sandbox, and its pictures are compared with the exact values or the solution's.
#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "framework/course/check/judge.h"
#include "framework/staff/grade/check_views.h"
#include "framework/staff/grade/mistake_names.h"
#include "framework/staff/grade/submission.h"

namespace relief::grade {

/// The two pictures that a failed check compared; they have the same shape. `drawn` comes from the submission and is
/// not trusted.
struct CheckPictures {
    std::string lab;  ///< folder
    const Manifest* manifest;
    CheckInfo check;           ///< with the shot that was drawn
    bool hidden_view = false;  ///< the shot is a hidden view, not the check's own
    Image drawn, expected;
};

/// Seconds, summed over processes.
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
    std::vector<check::TaskVerdict> tasks = {};
    std::string log = {};  ///< the compiler's messages, or empty
    MarkTimes times = {};
    /// Why a newer hand-in was not graded, so that this is the mark of an earlier one; or empty.
    std::string kept = {};

    /// Points of optional tasks make up for lost ones, up to the maximum.
    double points() const;
    int max_points() const;  ///< of the tasks that are not optional
    bool graded() const;     ///< returns whether no check failed through the grader's fault
};

/// Grades one lab. Draws the solution once, in the constructor. mark() is thread-safe.
class LabGrader {
public:
    /// Throws Error if the solution does not get all points on this machine; see LabViews.
    LabGrader(const LabEntry& lab, const Stage& stage, GradeSetup setup);

    const LabEntry& lab() const { return views_.lab(); }
    const Manifest& manifest() const { return views_.manifest(); }
    /// See LabViews.
    double solution_cpu() const { return views_.solution_cpu(); }
    void bound_by(double solution_cpu) { views_.bound_by(solution_cpu); }
    void reuse_shaders() { views_.reuse_shaders(); }
    /// Returns the number of checks that have a hidden view.
    size_t hidden_views() const { return views_.hidden_count(); }

    /// Judges the check that an example belongs to with this course's files, except for those that are edited.
    check::Verdict words_of(const ExampleInfo& example, const CourseFiles& edited) const;

    /// Grades a submission. Adds to `pictures` the pictures that failed checks compared; they point to this grader's
    /// manifest. `with_names`: whether to name known mistakes and relations to the expected picture.
    LabMark mark(const Submission& submission, std::vector<CheckPictures>* pictures = nullptr,
                 bool with_names = true) const;

private:
    check::Verdict judge_check(size_t check, const DrawnChecks& drawn) const;
    bool ran_out(const std::string& task, const DrawnChecks& drawn) const;
    std::map<size_t, check::Outcome> judge_each_alone(const Submission& submission,
                                                      const std::map<std::string, std::vector<size_t>>& lost,
                                                      DrawnChecks& drawn) const;
    bool depend_on_shaders(const std::vector<size_t>& checks) const;
    std::map<size_t, check::Outcome> judge_alone(const Submission& submission, const std::string& task,
                                                 const std::vector<size_t>& checks, DrawnChecks& drawn) const;
    void add_relation(size_t check, const DrawnChecks& drawn, check::Verdict& said) const;
    void keep_pictures(const Comparison& shown, bool is_hidden, std::vector<CheckPictures>& kept) const;

    LabViews views_;
    MistakeNames mistakes_;
    check::OtherShaders others_;
    mutable std::mutex base_mutex_;
    mutable std::map<size_t, std::optional<Image>> bases_;  ///< by check, see check::base_of()
};

}  // namespace relief::grade
