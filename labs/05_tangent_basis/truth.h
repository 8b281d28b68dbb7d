// The exact values of lab 05's probes, and the tangents that bakers agree on.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"
#include "shapes.h"

namespace relief::basis {

/// dP/du (`tangent`) or dP/dv (`dp_dv`) of the surface at the u and v that the mesh has in each pixel; for `bitangent`,
/// the direction across the normal and dP/du; for `frame`, the length of a tangent, its cosine with the normal, and the
/// handedness.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const CoarseMesh& mesh, Shape shape,
                                      double shear)>
    truth;

/// By the published semantics of MikkTSpace.
inline FromStaff<Mesh(const Mesh& mesh)> with_mikktspace;

}  // namespace relief::basis
