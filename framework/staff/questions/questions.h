// Questions about a student's own shaders, with answers, for a test of understanding. Every answer was computed by the
// student's code in the sandbox; those about known mistakes, by the solution's. Nothing here is asked about C++ tasks,
// whose files are replaced by the solution's.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "framework/course/task/rules.h"
#include "framework/staff/grade/check_views.h"
#include "framework/staff/grade/submission.h"
#include "framework/staff/proof/mutants.h"

namespace relief::grade {

/// Two pictures on a sheet differ at least so much: in this share of their pixels, by more than `distinct_change` in a
/// channel. Smaller differences are hard to see on paper.
constexpr double distinct_share = 0.05, distinct_change = 24.0 / 255 + 1e-6;

/// A change of one line of a student's file.
struct LineChange {
    int line = 0;
    std::string was, now;  ///< the whole line, without the spaces around it
    bool operator==(const LineChange&) const = default;
};

/// `value`: what does a function return at a pixel? `picture`: which of four pictures does a change of a line make?
/// `line`: which of four changes makes a picture? `mistake`: which of four known mistakes made this picture?
enum class QuestionKind { value, picture, line, mistake };

/// A question about one task. Texts that come from the submission are printable, but not escaped.
struct Question {
    QuestionKind kind = QuestionKind::value;
    std::string lab, task, file;  ///< the lab's folder; the task's id; its file
    std::string view;             ///< the name of the check whose view it is
    /// 8-bit: the student's own picture; then, for `line`, the changed one; for `picture`, the four choices alone; for
    /// `mistake`, the right picture and that of the mistake.
    std::vector<Image> pictures = {};
    std::string probe = {};  ///< the quantity that the pictures show, if it is a probe's
    // A value:
    glm::ivec2 pixel{0};
    check::LoneCall call = {};
    double margin = 0;          ///< how far an answer in numbers may be off
    bool mark_is_lost = false;  ///< the check fails, and this pixel is wrong: the question asks for the reason, too
    std::string drawn_here = {}, expected_here = {};  ///< the numbers of the check there, if the mark is lost
    std::string unit = {};                            ///< of these numbers, or empty
    std::string found = {}, look_at = {};             ///< the result and the hint of the failed check
    // A change of a line:
    std::vector<LineChange> changes = {};  ///< one for `picture`, four for `line`
    std::vector<std::string> hints = {};   ///< of four known mistakes, for `mistake`
    /// The key: the returned value, or the letter of the choice.
    std::string answer = {};
};

struct LabQuestions {
    std::vector<Question> questions;
    std::string problem;  ///< why there can be no question, in one line; or empty
};

/// Returns up to `count` pixels that are worth a question, in a seeded order. If `expected` is given, the error at each
/// is at least half of its maximum. Otherwise each shows something: a surface in a probe; in a picture, another colour
/// than in its upper left corner. Pixels at the border do not count.
std::vector<glm::ivec2> telling_pixels(const Image& drawn, const Image* expected, const ProbeInfo* probe, size_t count,
                                       const std::string& seed);

/// Returns whether a call is worth a question: its result is no mere 0, 1 or argument, and the rounded arguments give
/// the same result within a quarter of a percent.
bool is_telling(const check::LoneCall& call);

/// Returns the largest set, at most `count`, of the first pictures that all differ visibly from each other. The first
/// picture is in it. Empty images are omitted. See distinct_share.
std::vector<size_t> distinct_pictures(const std::vector<Image>& pictures, size_t count);

/// Returns the first `count` questions, the kinds in turn. Takes each lab's in turn, too.
std::vector<Question> chosen_questions(const std::vector<LabQuestions>& labs, size_t count);

/// Makes questions about one lab. Draws the solution once, in the constructor; see LabViews.
class QuestionMaker {
public:
    /// `setup.seed` is ignored: questions are about public views.
    QuestionMaker(const LabEntry& lab, const Stage& stage, GradeSetup setup);

    /// Returns up to `count` questions of each kind. `seed`: the same questions for the same submission and seed.
    /// `jobs`: mutants drawn at a time. `begins` is called `parts` times, before each part of the work.
    LabQuestions ask(const Submission& submission, size_t count, const std::string& seed, int jobs,
                     const std::function<void(const std::string& part)>& begins) const;
    static constexpr int parts = 4;

private:
    class Sheet;
    const LabEntry& lab_;
    const Stage& stage_;
    GradeSetup setup_;
    LabViews views_;
    check::OtherShaders others_;
};

}  // namespace relief::grade
