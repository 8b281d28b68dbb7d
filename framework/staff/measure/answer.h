// What a topic's measurements say in one sentence, and the scene that says it best.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/rows.h"

namespace relief {

/// Of all scenes the one with the most methods that can be compared by time and error; without such a one, the first
/// with the most measured methods. Empty if nothing was measured.
std::vector<size_t> chief_scene(std::span<const BenchRow> rows);

/// "Of 17 methods 4 are beaten by no other in both time and error. The fastest: offset (0.9 ms, mean error 12 texels). The
/// most accurate: exact (1.5 ms, mean error 0.001 texels), 1.7 times as long." Without errors it compares the fastest with the slowest; for sweeps it counts the methods
/// that keep their stated error everywhere.
std::string answer_of(std::span<const BenchRow> rows, const std::vector<size_t>& scene);

}  // namespace relief
