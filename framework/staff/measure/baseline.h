// Compares work and error with a baseline: both are independent of the machine's load.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/rows.h"

namespace relief::measure {

struct BaselineReport {
    /// One line for each regression: work or error that grew, a method that failed or is missing, a method that is not
    /// in the baseline.
    std::vector<std::string> worse;
    /// One line for each figure that fell: the baseline could be renewed.
    std::vector<std::string> better;
};

/// Compares the figures of rows with the same topic, scene, method and knobs. `tolerance` is the fraction by which a
/// figure may grow.
BaselineReport compare_with_baseline(std::span<const BenchRow> now, std::span<const BenchRow> baseline,
                                     double tolerance);

}  // namespace relief::measure
