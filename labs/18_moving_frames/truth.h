// The exact values of lab 18's probes.
#pragma once

#include <array>
#include <optional>

#include "framework/base/from_staff.h"
#include "framework/lab/lab.h"
#include "skin.h"

namespace relief::moving_frames {

/// The number of rings and sides of a skin's triangles.
struct Fineness {
    int rings, sides;
    int triangles() const { return 2 * rings * sides; }
    bool operator==(const Fineness&) const = default;
};

struct Scene {
    bool is_serpent;
    Pose pose;
    std::array<glm::dmat3, material_count> materials;  ///< texture transforms, applied after the instance's
    std::vector<Instance> instances;                   ///< the first one has more triangles than the others
    Fineness fine, coarse;
    bool unrolled;  ///< the picture is the first one's skin, u to the right and v up, both from 0 to 1
};

/// Returns the exact values of a probe at the place of the skin that a pixel's triangle shows:
///  - `normal`: unit normal in the world
///  - `tangent`: unit tangent along the texture's u, and its handedness in w
///  - `carried`: the body's x axis, moved to the world
///  - `fold`: determinant of the skin's Jacobian
///  - `place`: position in the world, metres
///  - `uv`: coordinates at which the texture is read
///  - `material`: index of the material
/// Returns nothing if an instance is degenerate.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Scene& scene)> truth;

}  // namespace relief::moving_frames
