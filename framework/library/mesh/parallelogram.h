// Parallelograms and boxes with uv in metres, and meshes of several parts.
#pragma once

#include "framework/core/base/mesh.h"

namespace relief {

/// The unit directions of u and v on a plane, as seen from its front: u to the right, v up.
struct PlaneAxes {
    glm::dvec3 right, up;
};
/// Returns the axes of a plane with a unit normal: `right` is horizontal, and +x if the plane is.
PlaneAxes plane_axes(const glm::dvec3& normal);

/// It faces cross(right, up), which must not be 0.
struct Parallelogram {
    glm::dvec3 corner, right, up;
    int cells = 1;    ///< along each side, at least 1
    double tile = 1;  ///< width of a texture tile, metres
};
/// Returns its mesh. uv are the distances of a position from the origin along plane_axes(), in tiles: parallelograms of
/// one plane continue each other's texture.
Mesh make_parallelogram(const Parallelogram& shape);

/// Returns the six faces of an axis-aligned box. Unlike those of make_box(), its uv are distances: see
/// make_parallelogram(); `tile` is in metres.
Mesh make_block(const glm::dvec3& low, const glm::dvec3& high, double tile = 1);

/// Appends a part, moved by `offset`, with its uv multiplied by `tiles`.
void append(Mesh& mesh, const Mesh& part, const glm::dvec3& offset = {0, 0, 0}, const glm::vec2& tiles = {1, 1});

}  // namespace relief
