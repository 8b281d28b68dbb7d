// Work and error compared with a baseline: they do not depend on the load of the machine.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/rows.h"

namespace relief {

struct BaselineReport {
    /// A line for each regression: work or error that grew, a method that failed or is gone, a method that is not in
    /// the baseline.
    std::vector<std::string> worse;
    /// A line for each figure that fell: the baseline could be renewed.
    std::vector<std::string> better;
};

/// Compares the figures of rows with the same topic, scene, method and knobs. `tolerance`: the share by which a figure
/// may grow.
BaselineReport compare_with_baseline(std::span<const BenchRow> now, std::span<const BenchRow> baseline,
                                     double tolerance);

}  // namespace relief
