// The exact values of lab 05's probes.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "shapes.h"

namespace relief::basis {

/// Returns the exact values of a probe at the u and v that the mesh has in each pixel: for `tangent` the unit dP/du,
/// for `dp_dv` the unit dP/dv, for `bitangent` the unit vector perpendicular to dP/du and to the normal. For `frame`
/// they are the length of the tangent, its cosine with the normal, and the handedness.
inline FromStaff<std::optional<Image>(const Frame& frame, const CoarseMesh& mesh, Shape shape, double shear)> truth;

}  // namespace relief::basis
