// The exact values of lab 12's probes.
#pragma once

#include "framework/core/base/from_staff.h"

#include <functional>
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

/// Returns the function that computes the exact values of a probe at the first hit of each pixel's ray. The meshes of
/// the objects must outlive it. Empty for other probes.
inline FromStaff<std::function<Image(const Frame&)>(const Probe& probe, const Sight& sight)> truth;

}  // namespace relief::exact
