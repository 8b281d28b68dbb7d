// Hidden views of a lab, drawn from a seed: what a picture that was stored, or code that is tuned to the views students
// know, does not get right.
#pragma once

#include <string>

#include "framework/lab/manifest.h"

namespace relief {

/// Another camera, and other values for the knobs under the manifest's `[vary]`: the same for every check of the lab,
/// so that two that are held against each other still can be.
class Variation {
public:
    /// The same seed and attempt give the same view on every machine. `attempt`: another one, when the solution itself
    /// does not get by in a view.
    Variation(const Manifest& manifest, const std::string& lab, const std::string& seed, int attempt);

    /// A knob that the shot sets is what its check is about, and stays.
    Shot vary(Shot shot) const;

private:
    double yaw_, pitch_;  ///< degrees, to be added
    double distance_;     ///< a factor
    std::vector<std::pair<std::string, std::string>> set_;
};

/// "camera 32,18,2.7; light_yaw 33"
std::string view_text(const Shot& shot);

}  // namespace relief
