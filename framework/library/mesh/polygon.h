// Polygons in space: their normals, and their triangulation.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace relief {

/// Returns the vector area of a polygon: its area times the normal from whose side the polygon is counter-clockwise
/// (Newell). For a polygon that is not flat, this is the integral over any surface with its outline. 0 when it has no
/// area.
glm::dvec3 vector_area(std::span<const glm::dvec3> corners);

/// Appends corners.size() - 2 triangles of three indices into `corners` each, with the polygon's winding. A quad is cut
/// along its shorter diagonal, unless that lies outside. A larger convex polygon is cut into a fan. Any other loses one
/// ear after the other (Meisters 1975), in time quadratic in its corners. If a polygon crosses itself or has no area,
/// triangles may overlap or be degenerate, but their number is the same. Fewer than three corners give no triangles.
void triangulate(std::span<const glm::dvec3> corners, std::vector<uint32_t>& triangles);

}  // namespace relief
