// A lab drawn by each of its methods, for its page: pictures of one shot, and their errors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "framework/lab/manifest.h"

namespace relief {

/// One value of the knob that is compared.
struct ComparedMethod {
    std::string name;
    Image picture;
    std::optional<Image> error;  ///< of the probe, one channel; nothing where there is no truth
    ErrorSummary summary = {};
};

struct Comparison {
    std::string knob;
    const ProbeInfo* probe = nullptr;  ///< nothing where there is no truth; of the manifest
    std::vector<ComparedMethod> methods;
    Shot measured;  ///< the last method's; its probe is the one of the errors
    /// The ends of the error maps' scale, the same for all methods. It is logarithmic: methods differ by powers of ten.
    /// `most`: what all but 1 % of each one's pixels keep to, rounded up to 1, 2 or 5 times a power of ten.
    double min = 0, max = 0;
};

/// What the manifest's [compare] says; without it the knob `method`, where there is one, by the manifest's camera, with
/// the first probe's error. Errors are left out where there is no truth, as in a student's course. Nothing for a lab
/// with neither table nor knob. In the current context. Throws UsageError for a knob or a value that is not there.
std::optional<Comparison> compare_methods(const LabEntry& lab, const Manifest& manifest);

/// An error as colours on that scale: black is `least` and less, pale yellow `most` and more.
Image error_map(const Comparison& comparison, const Image& error);

}  // namespace relief
