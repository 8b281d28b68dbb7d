// Whether a picture is like that of a known mistake: their values are compared where one of them differs from the
// solution's.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"

namespace relief {

/// Values of a picture at some places, or the error that came in its place.
struct Sample {
    std::vector<float> values = {};
    std::string error = {};
    bool is_drawn = false;
};

/// Samples of one known mistake, or of the solution, or of somebody's work, by check.
using Samples = std::map<size_t, Sample>;

/// Likenesses of several checks may be added up.
struct Likeness {
    size_t differ = 0;  ///< values in which the drawing or the mistake differs from the solution
    size_t agree = 0;   ///< of those, the values in which the drawing is like the mistake

    double share() const { return differ > 0 ? double(agree) / double(differ) : 0; }
};

/// The share of what differs from the solution that must agree with the mistake.
constexpr double min_agreement = 0.9;

/// How far a drawing that shows the mistake may be from it. For a picture two steps of 8 bits. For a probe 2 % of the
/// mistake's mean error: that works in any unit, and other mistakes cost more.
double tolerance_of(const Sample& mistake, const Sample& solution, bool is_probe);

/// Two NaNs are near each other, and so are two equal infinities.
bool is_near(float a, float b, double tolerance);

Likeness likeness(const Sample& drawn, const Sample& mistake, const Sample& solution, bool is_probe);

}  // namespace relief
