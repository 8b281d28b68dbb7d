// The exact values of lab 11's probes.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"
#include "framework/mesh/relief.h"

namespace relief::occlusion {

/// For `uv`, the point in texels where the view ray first meets the bilinear relief; for `depth`, how many metres that
/// is from the eye. A fragment that is seen from behind has no relief. Nothing for `steps`.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Mesh& mesh,
                                      const ReliefMapping& mapping, const Image& heights)>
    truth;

}  // namespace relief::occlusion
