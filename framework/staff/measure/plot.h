// Plots of a topic's scenes: error over time, drawn by gnuplot.
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

/// Returns the plot of the scene with most to compare, with letters for a slide; see scene_plot(). Precondition: all
/// rows are from one run.
std::optional<std::string> slide_plot(const BenchTopic& topic, std::span<const BenchRow> rows, bool is_quick);

/// Returns a row's name in a plot: its number in `style.numbered`, or else its short name.
std::string point_label(const BenchRow& row, size_t place, const PlotStyle& style);

/// Returns the rows whose names a narrow plot replaces by numbers, in the order of these numbers: the Pareto front and
/// the peers by time, or all curves of a sweep. None for bars, which have room for their names.
std::vector<size_t> numbered_rows(const BenchTopic& topic, std::span<const BenchRow> rows,
                                  const std::vector<size_t>& scene);

/// Returns a plot of one scene as SVG: mean error over time on log axes, with as many names as there is room for. The
/// Pareto front is a line, other points are pale, peers are blue diamonds. A scene without has_errors() has bars of
/// time instead, as high as they need. A point is an element `class="point" data-row="17"` with the row's name as its
/// title. Names of elements begin with `name`. The text is empty if no row has a time. Returns nothing if gnuplot is
/// not installed; throws Error if it fails.
std::optional<std::string> scene_plot(const BenchTopic& topic, std::span<const BenchRow> rows,
                                      const std::vector<size_t>& scene, const PlotStyle& style,
                                      const std::string& name);

}  // namespace relief::measure
