// A lab drawn by each of its methods, for its page: pictures of one shot, and error maps.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/course/manifest/manifest.h"

namespace relief::pages {

/// One value of the compared knob.
struct ComparedMethod {
    std::string name;
    Image picture;
    std::optional<Image> error;  ///< error of the probe, one channel; empty without exact values
    ErrorSummary summary = {};
};

struct Comparison {
    std::string knob;
    const ProbeInfo* probe = nullptr;  ///< owned by the manifest; null without exact values
    std::vector<ComparedMethod> methods;
    Shot measured;  ///< the last method's shot; its probe is the one of the errors
    /// The end of the error maps' scale, shared by all methods: error_map_max() of the largest 99 % quantile of a
    /// method's errors. The scale is logarithmic, because errors of methods differ by powers of ten.
    double max = 0;
};

/// Draws the comparison of the manifest's [compare]. Without that table it compares the values of the knob `method`,
/// from the manifest's camera, with the first probe's error. Omits errors without exact values, as in a student's
/// course. Returns nothing for a lab with neither table nor knob. Draws in the current context. Throws UsageError for
/// an unknown knob or value.
std::optional<Comparison> compare_methods(const LabEntry& lab, const Manifest& manifest);

/// Returns the end of an error map's scale: the 99 % quantile of the errors, rounded up to 1, 2 or 5 times a power of
/// ten. 1 if that is 0. The scale begins at a thousandth of it.
double error_map_max(double p99);
/// Returns an error as colours on the logarithmic scale up to `max`: black for max / 1000 and below, pale yellow for
/// `max` and above.
Image error_map(double max, const Image& error);

}  // namespace relief::pages
