// Proof that marks are right: what is known to be good, empty or wrong goes the way of a submission.
#pragma once

#include <string>
#include <vector>

#include "framework/staff/grade/marks.h"

namespace relief {

struct SelfTestOptions {
    int jobs = 1;
    /// So many mistakes and so many variants, evenly from what the manifest lists and always the same; 0: all. Naming
    /// a mistake takes pictures of all others of its task, so in a sample none is asked for its name.
    int sample = 0;
};

struct SelfTest {
    int mistakes = 0, caught = 0;         ///< caught: its task loses points
    int named = 0;                        ///< its id is told, or that of the one it is `same_as`
    int equivalents = 0, right = 0;       ///< right: all points of all tasks
    int left_out = 0;                     ///< mistakes and variants that are not in the sample
    size_t checks = 0, hidden_views = 0;  ///< views: with a seed
    std::vector<std::string> wrong;       ///< every wrong verdict, a line each
    double seconds = 0;
};

/// The solution gets all points, the starter none, every known mistake loses points of its task and is named, and every
/// correct variant, of which a lab with tasks has five at least, gets all points.
SelfTest test_grader(const LabEntry& lab, const GradeSetup& setup, SelfTestOptions options);

}  // namespace relief
