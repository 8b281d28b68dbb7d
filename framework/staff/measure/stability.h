// The scenes of the topic `stability`: error as a function of the input's difficulty.
#pragma once

#include <functional>
#include <vector>

#include "framework/staff/measure/bench.h"

namespace relief::measure {

std::vector<BenchScene> tangent_sweeps(const BenchSettings& settings);
std::vector<BenchScene> codec_sweeps(const BenchSettings& settings);
std::vector<BenchScene> height_sweeps(const BenchSettings& settings);
std::vector<BenchScene> hit_sweeps(const BenchSettings& settings);
std::vector<BenchScene> lab_sweeps(const BenchSettings& settings);
std::vector<BenchScene> layer_sweeps(const BenchSettings& settings);

/// Returns the screen error, in pixels, of lab 14's hilly ground with `knobs`. One value for each of 512 x 512 pixels
/// that shows the ground.
std::vector<double> ground_pixels_off(const BenchKnobs& knobs);

/// Returns 10^from, 10^(from + step), ... up to 10^to.
std::vector<double> decades(double from, double to, double step = 1);

/// A method of a sweep: `at` measures it at one hardness.
struct SweptMethod {
    std::string name;
    double stated;    ///< the maximum error that the method promises
    std::string why;  ///< a sentence, see BenchSweep
    std::function<BenchSweep::Place(double hardness)> at;
    bool peer = false;
    BenchKnobs knobs = {};
};

/// Returns a scene of sweeps. `input` names it; `axis` names the swept quantity.
BenchScene sweep_scene(const std::string& input, const std::string& axis, const std::string& unit,
                       const std::vector<double>& hardness, std::vector<SweptMethod> methods);

/// Collects the results at one point of a sweep: errors, and counts of failures.
class Tally {
public:
    void add(double error);  ///< NaN and infinity count as not finite
    void lost() { ++lost_; }
    void endless() { ++endless_; }
    BenchSweep::Place largest(double hardness) const;
    BenchSweep::Place mean(double hardness) const;
    BenchSweep::Place most(double hardness) const;  ///< 99th percentile of the errors

private:
    BenchSweep::Place place(double hardness, double error) const;
    std::vector<double> errors_;
    size_t lost_ = 0, endless_ = 0;
};

}  // namespace relief::measure
