// Error as a function of the input's difficulty: a summary of the curve, and its plot.
#pragma once

#include <span>
#include <string>

#include "framework/staff/measure/gnuplot.h"
#include "framework/staff/measure/rows.h"

namespace relief::measure {

/// Returns whether a method keeps its promise at this point: all results are finite and ended, and the error is at most
/// the stated one.
bool holds(const BenchSweep& sweep, const BenchSweep::Place& place);

/// Rounds a number of any magnitude to `digits` significant digits, for plain(): 1e-19, 31620.
double with_digits(double number, int digits);

/// Returns a subject without a time. Its error is the error over the points that hold (over all finite ones if none
/// holds). Its work counts the points that are wrong, not finite or endless.
BenchSubject swept(BenchSweep sweep, const std::string& unit);

/// Returns one line, which ends with the sweep's own sentence. It begins with "keeps 0.001 degrees for all inputs of
/// this sweep", or with "off by more than 0.001 degrees from 1e10 on, not finite from 1e13 on". `unit` is the unit of
/// the error.
std::string verdict_of(const BenchSweep& sweep, const std::string& unit);

/// Returns a gnuplot script: error over hardness on log axes, peers in blue, each curve named at its end. Results that
/// are not finite or do not end lie on a line above all others, zeros on a line below. Empty if no row has a sweep.
std::string sweep_script(std::span<const BenchRow> rows, const std::vector<size_t>& scene, const PlotStyle& style);

}  // namespace relief::measure
