// The section of a mesh by a plane.
#pragma once

#include <utility>
#include <vector>

#include "framework/core/base/mesh.h"

namespace relief {

/// Returns the ends of the line in which each triangle meets the plane through the origin that is perpendicular to
/// `normal` (of any length above 0), in the order of the triangles. A vertex on the plane counts as in front of it. So
/// a triangle in the plane has no line, and the section of a closed mesh is closed.
std::vector<std::pair<glm::dvec3, glm::dvec3>> plane_section(const Mesh& mesh, const glm::dvec3& normal);

}  // namespace relief
