// How many small changes of a lab's solution its checks notice.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "framework/staff/grade/marks.h"
#include "framework/staff/grade/mutants.h"

namespace relief {

struct MutationOptions {
    int jobs = 1;
    int sample = 0;  ///< so many mutants, evenly of all; 0: all
};

/// `killed`: its task loses points. `elsewhere`: only another task does. `survived`: nothing does, but a person sees
/// the difference in a picture that was tried. `unseen`: it differs, but less. `same`: to the bit. `invalid`: it does
/// not compile.
enum class MutantFate { killed, elsewhere, survived, unseen, same, invalid };
inline constexpr std::array mutant_fates = {"killed", "elsewhere", "survived", "unseen", "same", "invalid"};

struct MutantResult {
    Mutant mutant;
    MutantFate fate = MutantFate::same;
    bool accused = false;    ///< another task lost points, too
    double largest = 0;      ///< share of 1 by which a pixel differs at most, over the pictures tried
    double share = 0;        ///< of the pixels that differ visibly, in the picture with most of them
    std::string where = {};  ///< that picture: probe, camera and knobs
};

struct MutationTest {
    std::vector<MutantResult> results;  ///< in the order of the mutants
    size_t views = 0;                   ///< pictures in which survivors were looked at
    double seconds = 0;
    size_t count(MutantFate fate, const std::string& task = {}) const;
    /// Of those that can be seen: killed, elsewhere and survived.
    double kill_rate() const;
    /// Of those that lose points anywhere: the share in which no task but the edited one does.
    double own_rate() const;
};

/// Grades all mutants of a lab's solution, and looks for a difference where no mark is lost: in each check's view, each
/// reference screenshot, and in views at random, which follow from the setup's seed.
MutationTest test_mutants(const LabEntry& lab, const GradeSetup& setup, MutationOptions options);

}  // namespace relief
