// The derivative of a skin, in double precision: what lab 18's truth and its tests are made of.
#pragma once

#include "skin.h"

namespace relief::moving_frames {

/// The derivative of the pose by the place at rest.
glm::dmat3 exact_jacobian(const Body& body, const Pose& pose, const std::vector<Bone>& bones, glm::dvec2 uv);

/// det(m) times the inverse transpose of m, which exists for each m.
glm::dmat3 cofactors(const glm::dmat3& m);

}  // namespace relief::moving_frames
