// Proof that marks are right: what is known to be good, empty or wrong goes the way of a submission.
#pragma once

#include <string>
#include <vector>

#include "framework/grade/marks.h"

namespace relief {

struct SelfTest {
    int mistakes = 0, caught = 0;         ///< caught: its task loses points
    int named = 0;                        ///< its id is told, or that of the one it is `same_as`
    size_t checks = 0, hidden_views = 0;  ///< views: with a seed
    std::vector<std::string> wrong;       ///< every wrong verdict, a line each
    double seconds = 0;
};

/// The solution gets all points, the starter none, and every known mistake loses points of its task and is named.
SelfTest test_grader(const LabEntry& lab, const GradeSetup& setup, int jobs);

}  // namespace relief
