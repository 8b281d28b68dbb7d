// The exact values of lab 12's probes.
#pragma once

#include "framework/base/from_staff.h"

#include <optional>
#include <vector>

#include "scene.h"

namespace relief::exact {

struct Sight {
    std::vector<Object> objects;
    std::optional<Ball> ball;
    bool outline;         ///< reliefs end where they end, and bend with their base
    glm::dvec3 to_light;  ///< unit, in the world
};

inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Sight& sight)> truth;

}  // namespace relief::exact
