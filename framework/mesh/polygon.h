// Polygons in space: their normal, and the triangles they are cut into.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace relief {

/// The area of the polygon along the normal that sees it counter-clockwise; where it is not flat, the sum over any
/// surface within it (Newell). 0 when it has no area.
glm::dvec3 vector_area(std::span<const glm::dvec3> corners);

/// Adds corners.size() - 2 triangles, three indices into `corners` each, wound as the polygon is. A quad is cut along
/// its shorter diagonal, unless that lies outside; a larger polygon is cut into a fan if it is convex, and otherwise
/// ear by ear (Meisters 1975), in a time that grows with the square of its corners. Where a polygon crosses itself or
/// has no area, some triangles overlap or have none, but their number stays. Fewer than three corners give nothing.
void triangulate(std::span<const glm::dvec3> corners, std::vector<uint32_t>& triangles);

}  // namespace relief
