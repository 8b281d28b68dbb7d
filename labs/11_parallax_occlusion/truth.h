// The exact values of lab 11's probes.
#pragma once

#include <functional>

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "framework/library/mesh/relief.h"

namespace relief::occlusion {

/// Returns the function that computes the exact values of a probe in a frame: for `uv` the first hit of the view ray
/// with the bilinear relief, in texels; for `depth` its distance from the eye, in metres. A fragment seen from behind
/// has no relief. The mesh must outlive the function. Empty for `steps`.
inline FromStaff<std::function<Image(const Frame&)>(const Probe& probe, const Mesh& mesh, const ReliefMapping& mapping,
                                                    const Image& heights)>
    truth;

}  // namespace relief::occlusion
