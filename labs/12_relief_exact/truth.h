// The exact values of lab 12's probes.
#pragma once

#include "framework/core/base/from_staff.h"

#include <optional>
#include <vector>

#include "scene.h"

namespace relief::exact {

struct Sight {
    std::vector<Object> objects;
    std::optional<Ball> ball;
    bool outline;         ///< see Object in scene.h
    glm::dvec3 to_light;  ///< unit, in the world
};

/// Returns the exact values of the probes at the first hit of each pixel's ray.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Sight& sight)> truth;

}  // namespace relief::exact
