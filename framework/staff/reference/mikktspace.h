// Tangents by the published semantics of MikkTSpace (Mikkelsen 2008), word by word and slow: the reference for
// corner_tangents().
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/mesh/mesh.h"

namespace relief {

/// The tangent of each corner: xyz has unit length, w is the handedness. Zero where the semantics define none; there
/// corner_tangents() has a fallback. Compares every corner with every other: for small meshes only. Where the semantics
/// leave a choice to the order of work, it follows the rules of corner_tangents().
std::vector<glm::dvec4> mikktspace_reference(const Mesh& mesh);

}  // namespace relief
