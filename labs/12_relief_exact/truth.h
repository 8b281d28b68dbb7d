// The exact values of lab 12's probes.
#pragma once

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

std::optional<Image> truth(const Frame& frame, const Probe& probe, const Sight& sight);

}  // namespace relief::exact
