// Measures how many small changes of a lab's solution its checks detect.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "framework/staff/grade/marks.h"
#include "framework/staff/proof/mutants.h"

namespace relief::grade {

struct MutationOptions {
    int jobs = 1;
    int sample = 0;  ///< number of mutants to test, evenly spaced; 0: all
};

/// `killed`: its task loses points. `elsewhere`: only another task does. `survived`: no task does, but a person would
/// see the difference in a tested picture. `unseen`: pictures differ by less than a person would see. `same`: pictures
/// are equal to the bit. `invalid`: it does not compile.
enum class MutantFate { killed, elsewhere, survived, unseen, same, invalid };
inline constexpr std::array mutant_fates = {"killed", "elsewhere", "survived", "unseen", "same", "invalid"};

struct MutantResult {
    Mutant mutant;
    MutantFate fate = MutantFate::same;
    bool accused = false;    ///< another task lost points, too
    double largest = 0;      ///< maximum difference of a pixel over the tested pictures; 1 is the whole range
    double share = 0;        ///< maximum share of visibly different pixels in a picture
    std::string where = {};  ///< the picture with that share: probe, camera and knobs
};

struct MutationTest {
    std::vector<MutantResult> results;  ///< in the order of the mutants
    size_t views = 0;                   ///< number of pictures in which survivors were compared
    double seconds = 0;
    size_t count(MutantFate fate, const std::string& task = {}) const;
    /// Returns the killed share of all visible mutants: killed, elsewhere and survived.
    double kill_rate() const;
    /// Returns, of the mutants that lose points in any task, the share that loses points only in the edited task.
    double own_rate() const;
};

/// Grades all mutants of a lab's solution. Compares the pictures of mutants that lose no points: each check's view,
/// each reference screenshot, and random views, which follow from the setup's seed.
MutationTest test_mutants(const LabEntry& lab, const GradeSetup& setup, MutationOptions options);

}  // namespace relief::grade
