// The exact values of lab 18's probes.
#pragma once

#include <optional>

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "scene.h"

namespace relief::moving_frames {

/// Returns the exact values of a probe at the place of the skin that a pixel's triangle shows:
///  - `normal`: unit normal in the world
///  - `tangent`: unit tangent along the texture's u, and its handedness in w
///  - `carried`: the body's x axis, moved to the world
///  - `fold`: determinant of the skin's Jacobian
///  - `place`: position in the world, metres
///  - `uv`: coordinates at which the texture is read
///  - `material`: index of the material
/// Returns nothing if an instance is degenerate.
inline FromStaff<std::optional<Image>(const Frame& frame, const Scene& scene)> truth;

}  // namespace relief::moving_frames
