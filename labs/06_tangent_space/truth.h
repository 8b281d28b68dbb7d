// The exact values of lab 06's probe.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "scene.h"

namespace relief::frames {

/// The position of the surface in the world, and the map on it.
struct Pose {
    Shape shape;
    glm::dmat4 world_from_model;
    double strength;  ///< of the map; 0 is flat, or without a map
    double turn_rad;  ///< of the texture
};

/// Returns the exact normals of the bricks' surface. They are computed in model space, and moved to the world by the
/// inverse transpose. Returns nothing if world_from_model is singular.
inline FromStaff<std::optional<Image>(const Frame& frame, const Pose& pose)> truth;

}  // namespace relief::frames
