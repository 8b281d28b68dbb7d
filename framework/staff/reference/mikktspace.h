// Tangents by the published semantics of MikkTSpace (Mikkelsen 2008), implemented literally and slowly: the reference
// for corner_tangents().
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/core/base/mesh.h"

namespace relief {

/// Returns the tangent of each corner: xyz has unit length, w is the handedness. Zero where the semantics define none;
/// corner_tangents() has a fallback there. Compares every corner with every other, so use it for small meshes only.
/// Where the semantics depend on the processing order, it follows the rules of corner_tangents().
std::vector<glm::dvec4> mikktspace_reference(const Mesh& mesh);

}  // namespace relief
