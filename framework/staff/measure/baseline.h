// Work and error compared with a baseline: they do not depend on the load of the machine.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/rows.h"

namespace relief {

struct BaselineReport {
    /// A line for each that is worse: work or error that grew, a method that fails or is gone, a new one that is not
    /// in the baseline.
    std::vector<std::string> worse;
    /// A line for each figure that fell, and could be the new baseline.
    std::vector<std::string> better;
};

/// `tolerance`: by what share a figure may grow. Figures of rows that are the same in topic, scene, method and knobs
/// are compared.
BaselineReport compare_with_baseline(std::span<const BenchRow> now, std::span<const BenchRow> baseline,
                                     double tolerance);

}  // namespace relief
