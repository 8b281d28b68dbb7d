// The exact values of lab 09's probes.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "patches.h"

namespace relief::planet {

/// The view of a probe: from an eye, or as faces spread out flat.
struct Sight {
    Plan plan;
    Eye seen_from;    ///< the plan's eye, or another one that looks at the plan's patches
    int texels = 64;  ///< along the side of a patch's map
};

/// Returns the exact values of the probes `normal`, `seen`, `place`, `level` and `skirt`, as seen from an eye.
inline FromStaff<std::optional<Image>(glm::ivec2 size, const Probe& probe, const Sight& sight)> globe_truth;
/// Returns the exact values of the probes `direction`, `stretch`, `corner`, `gradient`, `texel`, `slope` and `normal`,
/// over a picture of all faces spread out.
inline FromStaff<std::optional<Image>(glm::ivec2 size, const Probe& probe, const Sight& sight)> flat_truth;

}  // namespace relief::planet
