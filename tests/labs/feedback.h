// The triangles that a lab's patches become, as the rasteriser gets them.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "framework/lab/shot.h"

namespace relief {

/// Three places a triangle, in the model. The lab is drawn once; its evaluation shader writes `v_position`. It must not
/// have compiled a program yet.
std::vector<glm::vec3> triangles_of(Lab& lab, const Shot& shot);

/// Edges that are not passed once each way by triangles that share the bits of both ends; edges without length do not
/// count. 0 for a closed surface.
size_t open_edges(const std::vector<glm::vec3>& triangles);

}  // namespace relief
