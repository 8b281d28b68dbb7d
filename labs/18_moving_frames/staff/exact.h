// The derivative of a skin in double precision, for lab 18's exact values and tests.
#pragma once

#include "skin.h"

namespace relief::moving_frames {

/// Returns the derivative of the posed position by the position at rest.
glm::dmat3 exact_jacobian(const Body& body, const Pose& pose, const std::vector<Bone>& bones, glm::dvec2 uv);

/// Returns the cofactors of m: det(m) times the inverse transpose, but defined for singular matrices, too.
glm::dmat3 cofactors(const glm::dmat3& m);

}  // namespace relief::moving_frames
