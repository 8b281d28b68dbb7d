// The one-sentence result of a topic's measurements, and the scene that shows it best.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/rows.h"

namespace relief::measure {

/// Returns the scene with the most measured methods, as indices of rows. Scenes with methods that are comparable by
/// time and error come before all others. On a tie, returns the first scene. Empty if nothing was measured.
std::vector<size_t> chief_scene(std::span<const BenchRow> rows);

/// Returns a text such as "Of 17 methods 4 are beaten by no other in both time and error. The fastest: offset (0.9 ms,
/// mean error 12 texels). The most accurate: exact (1.5 ms, mean error 0.001 texels), 1.7 times as long."
///
/// Noise may have decided the order of methods whose times overlap between p10 and p90. They are called about equal if
/// their medians are within a factor of 2 and none has is_wide(). Otherwise they cannot be told apart in this run.
///
/// Without errors it compares the fastest with the slowest. For sweeps it counts the methods that keep their stated
/// error for all inputs.
std::string answer_of(std::span<const BenchRow> rows, const std::vector<size_t>& scene);

}  // namespace relief::measure
