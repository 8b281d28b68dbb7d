// The exact values of lab 15's probes.
#pragma once

#include <vector>

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"

namespace relief::ocean {

/// One map on the water.
struct Layer {
    int map;
    double amplitude;      ///< metres of significant wave height
    double tiles;          ///< in tile_metres
    glm::dvec2 velocity;   ///< tiles a second
    glm::dvec2 offset{0};  ///< tiles, at time 0
};

struct Sea {
    std::vector<Layer> layers;
    double shininess = 512;
    glm::dvec3 to_light{0, 1, 0};
    bool displaced = false;     ///< waves rise from the plane y = 0
    bool whole_spread = false;  ///< `sigma` and `glitter` of the whole sea, not of a pixel's part of it
    bool exact_fresnel = false;
};

/// At the place where the ray through the middle of a pixel first meets the sea, by summed cosines: `normal`, `slope`
/// (along x and z), `height` (metres), `reflection`, `fresnel` (share). `sigma`: variance of the slope along x, along
/// z, and covariance; `glitter`: share of the light. Both over 32 x 32 places of the pixel's part of the sea.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Sea& sea)> truth;

}  // namespace relief::ocean
