// Error against how hard the input is: what a curve says, and its plot.
#pragma once

#include <span>
#include <string>

#include "framework/staff/measure/gnuplot.h"
#include "framework/staff/measure/rows.h"

namespace relief {

/// Whether a method keeps its promise there: all results finite and ended, and the error at most the stated one.
bool holds(const BenchSweep& sweep, const BenchSweep::Place& place);

/// A number of any size with so many digits that count, for plain(): 1e-19, 31620.
double with_digits(double number, int digits);

/// A subject without a time. Its error is that of the places that hold (of all finite ones if none does); its work
/// counts the places that are wrong, not finite or endless.
BenchSubject swept(BenchSweep sweep, const std::string& unit);

/// One line: "keeps 0.001 degrees everywhere", or "off by more than 0.001 degrees from 1e10 on, not finite from 1e13
/// on", then the sweep's own sentence. `unit`: of the error.
std::string verdict_of(const BenchSweep& sweep, const std::string& unit);

/// A script for gnuplot, one panel or a panel for each scene: error over hardness on log axes, methods from elsewhere blue. What is
/// not finite or does not end lies on a line above all others, 0 on one below. Empty if no row has a sweep.
std::string sweep_panel(std::span<const BenchRow> rows, const std::vector<size_t>& scene, const PanelStyle& style);
std::string sweep_script(const BenchTopic& topic, std::span<const BenchRow> rows, const BenchMachine& machine);

}  // namespace relief
