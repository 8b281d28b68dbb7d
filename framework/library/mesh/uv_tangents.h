// Tangents of a mesh without smoothing.
#pragma once

#include "framework/core/base/mesh.h"

namespace relief {

/// Sets the tangents at the vertices of each triangle from its gradients of u and v. xyz has unit length, is
/// perpendicular to the normal, and points along growing u; w is the handedness. A vertex of several triangles gets the
/// tangent of the last one. Triangles that are degenerate, in space or in uv, set none. Precondition: each index has a
/// vertex.
void set_uv_tangents(Mesh& mesh);

}  // namespace relief
