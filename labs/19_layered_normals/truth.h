// The exact values of lab 19's probes.
#pragma once

#include <optional>

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "settings.h"

namespace relief::layered_normals {

/// Returns the exact values of a probe, for the layers' maps with trilinear filtering:
///  - `normal`: unit normal of the wall that answers the question, or of a solid's displaced surface
///  - `detail`: unit normal of the grain, of its strength at the pixel
///  - `variance`: variance of the slopes by the filter
///  - `highlight`: mean over 1024 places of the pixel
///  - `weights`, `planes`, `gradient`: of a solid's planes their weights, the sum of their gradients, and the gradient
///    of the relief
///  - `reads`: number of layers or planes that a pixel reads
inline FromStaff<std::optional<Image>(const Frame& frame, const Settings& settings)> truth;

}  // namespace relief::layered_normals
