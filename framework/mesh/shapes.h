// Meshes of surfaces with a formula: their normals and tangents (dP/du) are exact, not averaged.
#pragma once

#include "framework/mesh/mesh.h"

namespace relief {

/// A rectangle in the plane z = 0 that faces +z, centred on the origin; u runs along x, v along y.
struct QuadShape {
    float width = 1, height = 1;
    int columns = 1, rows = 1;
    glm::vec2 repeat = {1, 1};  ///< how often the texture repeats along u and v
};
Mesh make_quad(const QuadShape& shape);

/// A column that stands on y = 0, without caps; u runs around (to the right, seen from outside), v up. Without height
/// and taper its normals point away from the axis.
struct ColumnShape {
    float bottom_radius = 1, top_radius = 1, height = 1;
    int sides = 48, rows = 8;
    glm::vec2 repeat = {1, 1};
};
Mesh make_column(const ColumnShape& shape);

/// A sphere around the origin; u runs around from -z (to the right, seen from outside), v from the lower pole
/// to the upper one. At a pole each of its vertices keeps the tangent of its own meridian.
struct SphereShape {
    float radius = 1;
    int sides = 48, rows = 24;
    glm::vec2 repeat = {1, 1};
};
Mesh make_sphere(const SphereShape& shape);

}  // namespace relief
