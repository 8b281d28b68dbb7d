// Hidden views of a lab, derived from a seed. They expose stored pictures, and code tuned to the views that students
// know.
#pragma once

#include <string>

#include "framework/course/manifest/manifest.h"

namespace relief::grade {

/// Another camera, and other values of the knobs in the manifest's `[vary]`. All checks of a lab get the same changes,
/// so two checks can still be compared with each other. If pictures do not depend on the camera (the map itself, six
/// faces side by side), `picture_size` in `[vary]` scales their size.
class Variation {
public:
    /// The same seed and attempt give the same view on every machine. Use another `attempt` if the solution itself
    /// fails in a view.
    Variation(const Manifest& manifest, const std::string& lab, const std::string& seed, int attempt);

    /// Returns the shot from the hidden view. A knob that the shot sets keeps its value, because the check is about it.
    Shot vary(Shot shot) const;

private:
    double yaw_, pitch_;  ///< added, in degrees
    double distance_;     ///< a factor
    double size_ = 1;     ///< a factor
    std::vector<std::pair<std::string, std::string>> set_;
};

/// Returns the shot in words: "camera 32,18,2.7; size 110x104; light_yaw 33".
std::string view_text(const Shot& shot);

}  // namespace relief::grade
