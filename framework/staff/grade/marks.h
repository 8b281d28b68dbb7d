// How a mark comes about: a submission's pictures, drawn in the sandbox, against the truth or what the solution draws
// there.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "framework/staff/grade/attempt.h"
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
    std::vector<CheckMark> checks;
    std::string mistake, hint;  ///< the known mistake whose pictures these are, or empty
};

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
    void add(const MarkTimes& more) { compile += more.compile, draw += more.draw, compare += more.compare; }
};

struct LabMark {
    std::string lab;  ///< folder
    std::vector<TaskMark> tasks;
    std::string log;  ///< what a compiler said at length, or empty
    MarkTimes times;

    double points() const;
    int max_points() const;
    bool graded() const;  ///< no check failed through the grader's fault
};

/// How submissions are drawn.
struct GradeSetup {
    Isolation isolation = Isolation::namespaces;
    /// For drawing a lab once, twice that in all, and three times that for compiling. 0: twenty, or ten times what the
    /// solution takes when that is more.
    double seconds = 0;
    size_t memory = size_t{2} << 30;  ///< bytes of addresses
    std::string seed = {};            ///< of the hidden views; none without
    Renderer renderer = {};
};

/// One lab with what its checks expect and its known mistakes' pictures: made once, then used by many threads.
class LabGrader {
public:
    /// Draws the solution in the sandbox first: throws Error when it does not get all points there, because then no
    /// mark of this machine can be trusted. With a seed each check also looks from a hidden view drawn from it (see
    /// Variation), but for those whose limits the solution itself does not keep there.
    LabGrader(const LabEntry& lab, const Stage& stage, GradeSetup setup);
    ~LabGrader();

    const LabEntry& lab() const { return lab_; }
    const Manifest& manifest() const { return manifest_; }
    /// Adds to `pictures`; their manifest is this grader's. Naming a known mistake draws all those of its task, once.
    LabMark mark(const Submission& submission, std::vector<CheckPictures>* pictures = nullptr,
                 bool name_mistakes = true) const;
    /// How many checks have a hidden view.
    size_t hidden_views() const { return views_.size() - manifest_.checks.size(); }

private:
    struct Sampled;
    struct Signature;

    /// What is drawn for a check: its own shot, or that of the hidden view.
    struct View {
        size_t check;
        Shot shot;
        std::optional<Image> expected = {};  ///< nothing for a check against another
        size_t against = 0;                  ///< for those: the view that is looked at in the same way
    };

    /// A hidden check or a hidden view. Whoever is asked for one has nothing to say to students.
    bool is_secret(size_t view) const {
        return view >= manifest_.checks.size() || manifest_.checks[views_[view].check].hidden;
    }
    void look_from_hidden_views(const CourseFiles& solution);
    void expect(View& view, const Attempt& solution, size_t first) const;
    /// By view; what is not wanted stays empty.
    Attempt draw(const CourseFiles& files, const std::vector<bool>& wanted) const;
    Judgement judge_view(size_t view, const Attempt& pictures) const;
    /// `view` becomes the one that the mark speaks of.
    CheckMark judge_check(size_t check, const Attempt& pictures, size_t& view) const;
    void keep_pictures(size_t view, const Attempt& pictures, std::vector<CheckPictures>& kept) const;
    /// `compared`: the checks that are about this task's own code, since they were drawn and no other task has to be
    /// put right first.
    void name_mistake(TaskMark& task, const Attempt& pictures, const std::vector<bool>& compared) const;
    std::map<size_t, Sampled> pictures_of(const MistakeInfo& mistake) const;
    const std::vector<Signature>& signatures(const std::string& task) const;
    std::vector<bool> views_of(const std::vector<bool>& checks, bool with_hidden) const;

    const LabEntry& lab_;
    const Stage& stage_;
    GradeSetup setup_;
    Manifest manifest_;
    std::vector<View> views_;  ///< one of each check, in order, and then the hidden ones
    struct Lazy;
    std::unique_ptr<Lazy> lazy_;
};

}  // namespace relief
