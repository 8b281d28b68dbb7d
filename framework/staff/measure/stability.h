// The scenes of the topic `stability`: error against how hard the input is.
#pragma once

#include <functional>
#include <vector>

#include "framework/staff/measure/bench.h"

namespace relief {

std::vector<BenchScene> tangent_sweeps(const BenchSettings& settings);
std::vector<BenchScene> codec_sweeps(const BenchSettings& settings);
std::vector<BenchScene> height_sweeps(const BenchSettings& settings);
std::vector<BenchScene> hit_sweeps(const BenchSettings& settings);
std::vector<BenchScene> lab_sweeps(const BenchSettings& settings);

/// By how many pixels lab 14's ground of hills is off, at each pixel of 512 x 512 that shows it, with these of its
/// knobs.
std::vector<double> ground_pixels_off(const BenchKnobs& knobs);

/// 10^from, 10^(from + step), ... to 10^to.
std::vector<double> decades(double from, double to, double step = 1);

/// A method of a sweep: `at` measures it at one hardness.
struct SweptMethod {
    std::string name;
    double stated;    ///< the error that it promises
    std::string why;  ///< a sentence, see BenchSweep
    std::function<BenchSweep::Place(double hardness)> at;
    bool peer = false;
    BenchKnobs knobs = {};
};

/// A scene of sweeps. `input` names it; `axis` says what grows.
BenchScene sweep_scene(const std::string& input, const std::string& axis, const std::string& unit,
                       const std::vector<double>& hardness, std::vector<SweptMethod> methods);

/// Collects the results at one place: errors, and what has none.
class Tally {
public:
    void add(double error);  ///< NaN or infinite: counts as not finite
    void lost() { ++lost_; }
    void endless() { ++endless_; }
    BenchSweep::Place largest(double hardness) const;
    BenchSweep::Place mean(double hardness) const;
    BenchSweep::Place most(double hardness) const;  ///< the error that 99 of 100 results keep

private:
    BenchSweep::Place place(double hardness, double error) const;
    std::vector<double> errors_;
    size_t lost_ = 0, endless_ = 0;
};

}  // namespace relief
