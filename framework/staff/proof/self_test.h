// The grader's self-test: grades the solution, the starter, and every known mistake and correct variant as submissions.
#pragma once

#include <string>
#include <vector>

#include "framework/staff/grade/marks.h"

namespace relief::grade {

struct SelfTestOptions {
    int jobs = 1;
    /// The number of mistakes, and of variants, to grade; 0: all. They are evenly spaced in the manifest's lists, and
    /// always the same. A sample does not name mistakes, because that would draw all other mistakes of the task.
    int sample = 0;
};

struct SelfTest {
    int mistakes = 0, caught = 0;         ///< caught: its task lost points
    int named = 0;                        ///< named by its own id, or by the id that it is `same_as`
    int equivalents = 0, right = 0;       ///< right: all tasks got all points
    int examples = 0;                     ///< whose edits were tried
    int left_out = 0;                     ///< number of mistakes and variants outside the sample
    size_t checks = 0, hidden_views = 0;  ///< hidden views: only with a seed
    std::vector<std::string> wrong;       ///< one line for each wrong verdict
    double seconds = 0;
};

/// Tests that the solution gets all points and the starter none; that every known mistake costs points of its task and
/// is named; that every example notices its edits; and that every correct variant gets all points. A lab with tasks
/// must have at least five variants.
SelfTest test_grader(const LabEntry& lab, const GradeSetup& setup, SelfTestOptions options);

}  // namespace relief::grade
