// Tangents for a whole mesh, by the functions of task.cpp.
#pragma once

#include "framework/mesh/mesh.h"
#include "task.h"

namespace relief::basis {

enum class Axis { tangent, bitangent };

/// Every corner a vertex of its own, with the frame of its triangle: T in `tangent.xyz`, or B.
Mesh with_faces(const Mesh& mesh, Axis axis = Axis::tangent);

/// The weighted mean at each vertex, of mirrored triangles and of the others apart: together they would cancel out.
Mesh with_means(const Mesh& mesh, Weight weight);

}  // namespace relief::basis
