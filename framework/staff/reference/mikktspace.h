// Tangents by the published semantics of MikkTSpace (Mikkelsen 2008), word by word and slowly: what the fast ones are
// held to.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/mesh/mesh.h"

namespace relief {

/// The tangent of each corner: xyz unit, w the handedness; zero where the semantics give none (corner_tangents falls
/// back there). Every corner is compared with every other: for small meshes. Where the semantics leave something to the
/// order of work, the same rules as corner_tangents.
std::vector<glm::dvec4> mikktspace_reference(const Mesh& mesh);

}  // namespace relief
