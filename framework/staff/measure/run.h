// A scene measured in a separate process: a method that crashes does not end the others.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "framework/context/context.h"
#include "framework/staff/measure/rows.h"

namespace relief {

/// By timer queries: the GPU's own time, from the first command to the last. Needs a context.
double by_gpu_clock(const std::function<void()>& run, size_t times);

struct BenchRun {
    BenchSettings settings;
    std::optional<ContextKind> context = {};  ///< for topics that draw; nothing: whichever opens
    bool pinned = false;                      ///< the same bits on every machine, at the cost of time
    /// Called at every step with the results so far and the next step ("linear-32, error", "round 3").
    std::function<void(const std::vector<BenchRow>& rows, const std::string& next)> report = {};
};

/// How many times `report` is called for a scene in which nothing fails.
int steps_of(const BenchScene& scene, const BenchSettings& settings);

/// The scene's rows, each measured or with the reason why not: a method that throws, crashes or gives what is not a
/// number, and the others go on. `machine` learns what drew and which clock was used. Throws Error when there is no
/// context, or the process cannot be made.
std::vector<BenchRow> run_scene(const BenchTopic& topic, const BenchScene& scene, const BenchRun& run,
                                BenchMachine& machine);

}  // namespace relief
