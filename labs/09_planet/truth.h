// The exact values of lab 09's probes.
#pragma once

#include "framework/base/from_staff.h"
#include "patches.h"

namespace relief::planet {

/// What a probe is seen as: from an eye, or as faces spread out flat.
struct Sight {
    Plan plan;
    Eye seen_from;    ///< the plan's own eye, or one that looks at what that needs
    int texels = 64;  ///< of a patch's map
};

/// From an eye: `normal`, `seen`, `place`, `level`, `skirt`.
inline FromStaff<std::optional<Image>(glm::ivec2 size, const Probe& probe, const Sight& sight)> globe_truth;
/// Spread out: `direction`, `stretch`, `corner`, `gradient`, `texel`, `slope`, `normal`, over a picture of all faces.
inline FromStaff<std::optional<Image>(glm::ivec2 size, const Probe& probe, const Sight& sight)> flat_truth;

}  // namespace relief::planet
