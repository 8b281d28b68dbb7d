// The exact values of lab 06's probe.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"
#include "scene.h"

namespace relief::frames {

/// How the surface lies in the world, and the map on it.
struct Pose {
    Shape shape;
    glm::dmat4 world_from_model;
    double strength;  ///< of the map; 0 is flat, or no map
    double turn_rad;  ///< of the texture
};

/// The normal of the bricks' own surface, worked out in the model's space and taken to the world by the inverse
/// transpose. Nothing where the model is flattened to nothing.
inline FromStaff<std::optional<Image>(const Frame& frame, const Pose& pose)> truth;

}  // namespace relief::frames
