// The exact values of lab 05's probes, and the tangents that bakers agree on.
#pragma once

#include "framework/lab/lab.h"
#include "shapes.h"

namespace relief::basis {

/// dP/du or dP/dv (`bitangent`) of the surface at the u and v that the mesh has in each pixel. Nothing in a student's
/// course.
std::optional<Image> truth(const Frame& frame, const Probe& probe, const CoarseMesh& mesh, Shape shape, double shear);

/// By the published semantics of MikkTSpace. Throws Error in a student's course.
Mesh with_mikktspace(const Mesh& mesh);

}  // namespace relief::basis
