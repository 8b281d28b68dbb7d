// Measures a scene in a separate process, so that a crashing method does not end the run.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "framework/core/context/context.h"
#include "framework/staff/measure/rows.h"

namespace relief::measure {

/// Returns the GPU's time for the commands of all runs, in seconds, by timer queries. The time in which the GPU waits
/// between two runs does not count. Needs a context.
double by_gpu_clock(const std::function<void()>& run, size_t times);

struct BenchRun {
    BenchSettings settings;
    std::optional<ContextKind> context = {};  ///< for topics that draw; empty: the first that opens
    bool pinned = false;                      ///< same bits on every machine, but slower
    /// Called at each step with the results so far and the name of the next step ("linear, its error and work").
    std::function<void(const std::vector<BenchRow>& rows, const std::string& next)> report = {};
};

/// Returns the number of calls of `report` for a scene in which nothing fails.
int steps_of(const BenchScene& scene, const BenchSettings& settings);

/// Measures the scene's methods. A method that throws, crashes or returns NaN gets a row with the reason; the others
/// continue. Fills in the renderer of `machine`. Throws Error if no context opens or no process can be
/// started.
std::vector<BenchRow> run_scene(const BenchTopic& topic, const BenchScene& scene, const BenchRun& run,
                                BenchMachine& machine);

}  // namespace relief::measure
