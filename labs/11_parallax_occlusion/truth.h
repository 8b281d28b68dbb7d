// The exact values of lab 11's probes.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "framework/core/mesh/relief.h"

namespace relief::occlusion {

/// Returns the exact values of a probe: for `uv` the first hit of the view ray with the bilinear relief, in texels; for
/// `depth` its distance from the eye, in metres. A fragment seen from behind has no relief. Returns nothing for
/// `steps`.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Mesh& mesh,
                                      const ReliefMapping& mapping, const Image& heights)>
    truth;

}  // namespace relief::occlusion
