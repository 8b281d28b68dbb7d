// How a mark comes about: a submission's pictures, drawn in the sandbox, against the truth or what the solution draws
// there.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/grade/check.h"
#include "framework/grade/drawing.h"
#include "framework/grade/stage.h"
#include "framework/grade/submission.h"

namespace relief {

struct CheckMark {
    std::string name;
    Outcome outcome = Outcome::machine;
    std::string found;    ///< what was measured, or what went wrong
    std::string look_at;  ///< what to look at next; empty when it passed
    bool hidden = false;
};

struct TaskMark {
    std::string id, title, file;
    int of = 0;         ///< points
    double points = 0;  ///< in equal shares for its checks
    std::vector<CheckMark> checks;
    std::string mistake, hint;  ///< the known mistake whose pictures these are, or empty
};

/// Seconds; those of several processes are added up.
struct MarkTimes {
    double compile = 0, draw = 0, compare = 0;
};

struct LabMark {
    std::string lab;  ///< folder
    std::vector<TaskMark> tasks;
    std::string log;  ///< what a compiler said at length, or empty
    MarkTimes times;

    double points() const;
    int of() const;
    bool graded() const;  ///< nothing in it failed for the machine's sake
};

struct GradeLimits {
    /// For drawing a lab once, twice that in all, and three times that for compiling. 0: twenty, or ten times what the
    /// solution takes when that is more.
    double seconds = 0;
    size_t memory = size_t{2} << 30;  ///< bytes of addresses
};

/// One lab with what its checks expect and its known mistakes' pictures: made once, then used by many threads.
class LabGrader {
public:
    /// Draws the solution in the sandbox first: throws Error when it does not get all points there, because then no
    /// mark of this machine can be trusted.
    LabGrader(const LabEntry& lab, const Stage& stage, Isolation isolation, GradeLimits limits);
    ~LabGrader();

    const LabEntry& lab() const { return lab_; }
    const Manifest& manifest() const { return manifest_; }
    LabMark mark(const Submission& submission) const;
    /// Seconds that the solution took to draw.
    double solution_seconds() const { return solution_seconds_; }

private:
    struct Pictures;
    struct Sampled;
    struct Signature;

    Pictures draw(const CourseFiles& files, const std::vector<bool>& wanted) const;
    void draw_on(const StagedCourse& course, Pictures& pictures, const std::vector<size_t>& which) const;
    CheckMark judge_one(size_t check, const Pictures& pictures) const;
    void name_mistake(TaskMark& task, const Pictures& pictures) const;
    std::map<size_t, Sampled> pictures_of(const MistakeInfo& mistake) const;
    const std::vector<Signature>& signatures(const std::string& task) const;
    std::vector<bool> wanted_checks(const std::set<std::string>& tasks) const;

    const LabEntry& lab_;
    const Stage& stage_;
    Isolation isolation_;
    GradeLimits limits_;
    Manifest manifest_;
    std::vector<std::optional<Image>> expected_;  ///< of each check, but of those against another
    double solution_seconds_ = 0;
    struct Lazy;
    std::unique_ptr<Lazy> lazy_;
};

}  // namespace relief
