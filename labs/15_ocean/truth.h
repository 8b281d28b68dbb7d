// The exact values of lab 15's probes.
#pragma once

#include <vector>

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"

namespace relief::ocean {

/// One map on the water.
struct Layer {
    int map;
    double amplitude;      ///< metres of significant wave height
    double tiles;          ///< tiles per tile_metres
    glm::dvec2 velocity;   ///< tiles per second
    glm::dvec2 offset{0};  ///< tiles, at time 0
};

struct Sea {
    std::vector<Layer> layers;
    double shininess = 512;
    glm::dvec3 to_light{0, 1, 0};
    bool displaced = false;     ///< waves rise from the plane y = 0
    bool whole_spread = false;  ///< `sigma` and `glitter` are for the whole sea, not for a pixel's footprint
    bool exact_fresnel = false;
};

/// Returns the exact values of a probe, by sums of cosines, where the ray through a pixel's centre first hits the sea,
/// from above or from below:
///  - `normal`: unit normal
///  - `slope`: slope along x and along z
///  - `height`: metres
///  - `reflection`: direction from which the mirrored light comes
///  - `fresnel`: share of the light that is mirrored
///  - `sigma`: variance of the slope along x, along z, and covariance
///  - `glitter`: share of the sun's light
/// `sigma` and `glitter` are means of 32 x 32 places of the pixel's footprint on the sea.
inline FromStaff<std::optional<Image>(const Frame& frame, const Sea& sea)> truth;

}  // namespace relief::ocean
