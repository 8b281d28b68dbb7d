// A topic's plot: error over time for each scene, drawn by gnuplot.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/gnuplot.h"
#include "framework/staff/measure/rows.h"

namespace relief {

/// The scenes of some rows, in their order: the places of the rows of each.
std::vector<std::vector<size_t>> scenes_of(std::span<const BenchRow> rows);

/// True when a scene's rows can be held against each other by their errors: two or more have one, all in one unit.
bool has_errors(std::span<const BenchRow> rows, const std::vector<size_t>& scene);

/// The rows of a scene that no other is better than, in time and in mean error; none where has_errors() is false.
std::vector<size_t> front_of(std::span<const BenchRow> rows, const std::vector<size_t>& scene);

/// A panel for each scene: mean error over time on log axes, the front of those that none is better than as a line, the
/// others pale, methods from elsewhere blue; bars of time where has_errors() is false. A point is an element
/// `class="point" data-row="17"` with the row's name as its title. SVG; empty when no row has a time. All rows must be
/// of one run: what `machine` says stands over them. Nothing when gnuplot is not installed; throws Error when it fails.
std::optional<std::string> bench_plot(const BenchTopic& topic, std::span<const BenchRow> rows,
                                      const BenchMachine& machine);

/// One scene of them, large, with as many names as there is room for. `name` begins its elements' names.
std::optional<std::string> scene_plot(const BenchTopic& topic, std::span<const BenchRow> rows,
                                      const std::vector<size_t>& scene, const PanelStyle& style,
                                      const std::string& name);

}  // namespace relief
