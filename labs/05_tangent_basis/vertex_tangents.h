// Tangents for a whole mesh, by the functions of task.cpp.
#pragma once

#include "framework/core/mesh/mesh.h"
#include "task.h"

namespace relief::basis {

enum class Axis { tangent, bitangent };

/// Returns a mesh with a vertex for each corner, which has the frame of its triangle: T in `tangent.xyz`, or B.
Mesh with_faces(const Mesh& mesh, Axis axis = Axis::tangent);

/// Returns a mesh with the weighted mean of the triangles' T or B at each vertex, in `tangent.xyz`. Mirrored triangles
/// have a mean, and a vertex, of their own, since together with the others they would cancel out.
Mesh with_means(const Mesh& mesh, Weight weight, Axis axis = Axis::tangent);

}  // namespace relief::basis
