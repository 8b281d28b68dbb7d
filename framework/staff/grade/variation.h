// Hidden views of a lab, derived from a seed. They catch stored pictures, and code that is tuned to the views that
// students know.
#pragma once

#include <string>

#include "framework/lab/manifest.h"

namespace relief {

/// Another camera, and other values of the knobs in the manifest's `[vary]`. They are the same for every check of the
/// lab, so that two checks can still be compared with each other. Where pictures do not depend on the camera (the map
/// itself, six faces side by side), `picture_size` in `[vary]` is a factor of their size.
class Variation {
public:
    /// The same seed and attempt give the same view on every machine. Use another `attempt` if the solution itself
    /// fails in a view.
    Variation(const Manifest& manifest, const std::string& lab, const std::string& seed, int attempt);

    /// The shot from the hidden view. A knob that the shot sets keeps its value: the check is about it.
    Shot vary(Shot shot) const;

private:
    double yaw_, pitch_;  ///< degrees to add
    double distance_;     ///< a factor
    double size_ = 1;     ///< a factor
    std::vector<std::pair<std::string, std::string>> set_;
};

/// "camera 32,18,2.7; size 110x104; light_yaw 33"
std::string view_text(const Shot& shot);

}  // namespace relief
