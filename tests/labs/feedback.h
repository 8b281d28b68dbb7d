// Captures the triangles that a lab's patches become, as the rasteriser receives them.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/core/lab/shot.h"

namespace relief {

/// Returns three positions per triangle, in model space. Draws the lab once, and its evaluation shader must write
/// `v_position`. Precondition: the lab has not compiled a program yet.
std::vector<glm::vec3> triangles_of(Lab& lab, const Shot& shot);

/// Counts the open edges: edges that triangles do not traverse equally often in both directions. Positions are equal if
/// their bits are equal. Edges of zero length are ignored. Returns 0 for a closed surface.
size_t open_edges(const std::vector<glm::vec3>& triangles);

}  // namespace relief
