// The exact values of lab 18's probes.
#pragma once

#include <array>
#include <optional>

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"
#include "skin.h"

namespace relief::moving_frames {

/// Rings and sides of a skin's triangles.
struct Fineness {
    int rings, sides;
    int triangles() const { return 2 * rings * sides; }
    bool operator==(const Fineness&) const = default;
};

struct Scene {
    bool is_serpent;
    Pose pose;
    std::array<glm::dmat3, material_count> materials;  ///< texture transforms, after those of the instances
    std::vector<Instance> instances;                   ///< the first one is drawn with more triangles than the others
    Fineness fine, coarse;
    bool unrolled;  ///< the picture is the first one's skin: u to the right, v up, both from 0 to 1
};

/// At the place of the skin that a pixel shows, which is what its triangle says. `normal`: unit, in the world.
/// `tangent`: along the texture's u, unit, and its handedness in w. `carried`: the world's image of the body's x axis.
/// `fold`: the determinant of the skin's Jacobian. `place`: metres. `uv`: where the texture is read. `material`: its
/// index.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Scene& scene)> truth;

}  // namespace relief::moving_frames
