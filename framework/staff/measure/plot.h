// A topic's plot: error over time for each scene, drawn by gnuplot.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "framework/staff/measure/gnuplot.h"
#include "framework/staff/measure/rows.h"

namespace relief::measure {

/// Returns the scenes in the order of the rows; each scene is a list of indices of rows.
std::vector<std::vector<size_t>> scenes_of(std::span<const BenchRow> rows);

/// Returns whether a scene's rows can be compared by error: two or more have one, all in one unit.
bool has_errors(std::span<const BenchRow> rows, const std::vector<size_t>& scene);

/// Returns the rows of a scene on the Pareto front of time and mean error; none if has_errors() is false.
std::vector<size_t> front_of(std::span<const BenchRow> rows, const std::vector<size_t>& scene);

/// Returns a plot as SVG, with a panel for each scene: mean error over time on log axes. The Pareto front is a line,
/// other points are pale, peers are blue diamonds. A single scene has letters for a slide. A scene without has_errors()
/// has bars of time instead. A point is an element `class="point" data-row="17"` with the row's name as its title. The
/// text is empty if no row has a time. Precondition: all rows are from one run, because the title of several
/// scenes names `machine`. Returns nothing if gnuplot is not installed; throws Error if it fails.
std::optional<std::string> bench_plot(const BenchTopic& topic, std::span<const BenchRow> rows,
                                      const BenchMachine& machine);

/// Returns a row's name in a plot: its number in `style.numbered`, or else its short name.
std::string point_label(const BenchRow& row, size_t place, const PanelStyle& style);

/// Returns the rows whose names a narrow plot replaces by numbers, in the order of these numbers: the Pareto front and
/// the peers by time, or all curves of a sweep. None for bars, which have room for their names.
std::vector<size_t> numbered_rows(const BenchTopic& topic, std::span<const BenchRow> rows,
                                  const std::vector<size_t>& scene);

/// Returns a plot of one scene, with as many names as there is room for. Names of its elements begin with `name`.
std::optional<std::string> scene_plot(const BenchTopic& topic, std::span<const BenchRow> rows,
                                      const std::vector<size_t>& scene, const PanelStyle& style,
                                      const std::string& name);

}  // namespace relief::measure
