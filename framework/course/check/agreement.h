// Compares a picture with the picture of a known mistake, at the values where one of them differs from the solution's.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"

namespace relief::check {

/// Values of a picture at some places, or the error that replaced it.
struct Sample {
    std::vector<float> values = {};
    std::string error = {};
    bool is_drawn = false;
};

/// Samples of a known mistake, the solution, or a submission, by check.
using Samples = std::map<size_t, Sample>;

/// The result of a comparison. Results of several checks can be added up.
struct Agreement {
    /// Number of different values below which agreement may be chance: many programs draw yes and no in the same
    /// places.
    static constexpr size_t certain_kinds = 4;

    size_t differ = 0;  ///< number of values in which the drawing or the mistake differs from the solution
    size_t agree = 0;   ///< number of these in which the drawing is like the mistake
    /// The first of these values that differ from each other, at most certain_kinds.
    std::vector<float> kinds = {};

    double share() const { return differ > 0 ? double(agree) / double(differ) : 0; }
    bool is_certain() const { return kinds.size() >= certain_kinds; }
    void add_kind(float value, double tolerance);
    void add(const Agreement& other);
};

/// How exactly a drawing that shows a mistake repeats the mistake's own, see tolerance_of().
struct Exactness {
    double picture = 2.0 / 255;  ///< for a value of a picture
    double probe = 0.02;         ///< for a value of a probe: share of the mistake's mean error
    /// Lower bound of share() for a match, in each check. One of the 24 values that distinguish mistakes may differ,
    /// such as a pixel at an edge with another driver.
    double agreement = 0.94;
    /// Whether a check that passes must also repeat the solution's values where the mistake does not change them.
    bool compares_passed = true;
};
/// For renderers that did not draw the fingerprints. In a simulation with SwiftShader's pictures of 362 mistakes, 252
/// instead of 128 are named, and 9 instead of 4 with another's name.
inline constexpr Exactness other_renderer{
    .picture = 10.0 / 255, .probe = 0.1, .agreement = 0.7, .compares_passed = false};

/// Returns whether a check's picture matches the mistake's. If neither picture differs from the solution's, they match
/// only if the check passed.
bool is_like(const Agreement& one, bool passed, const Exactness& exactness = {});

/// Returns a known mistake's hint for a message. If few values agree, or after a single failed check, the hint is only
/// a possibility, because other mistakes may draw the same there. So are the hints of mistakes that all draw the same.
std::string told(const std::string& hint, bool is_certain, size_t failed_checks);

/// Returns how much a drawing that shows the mistake may differ from the mistake's own. For a picture,
/// `exactness.picture`. For a probe, the share `exactness.probe` of the mistake's mean error where it differs from the
/// solution: that works in any unit. By the default share, other mistakes differ by more. At least the rounding of
/// another driver: a mistake that only rounds differently draws the solution's picture.
double tolerance_of(const Sample& mistake, const Sample& solution, bool is_probe, const Exactness& exactness = {});

/// Returns whether two values differ by at most `tolerance`. Two NaNs are near each other, and so are two equal
/// infinities.
bool is_near(float a, float b, double tolerance);

Agreement agreement(const Sample& drawn, const Sample& mistake, const Sample& solution, bool is_probe,
                    const Exactness& exactness = {});

}  // namespace relief::check
