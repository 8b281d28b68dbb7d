// The bodies of lab 18's picture, for the passes and for the exact values.
#pragma once

#include <array>
#include <vector>

#include "settings.h"

namespace relief::moving_frames {

struct Scene {
    const Body& body;
    Pose pose;
    Ball ball;                                         ///< around every body
    std::array<glm::dmat3, material_count> materials;  ///< texture transforms, applied after the instance's
    std::vector<Instance> instances;                   ///< the first one has more triangles than the others
    Fineness fine, coarse;
    bool unrolled;  ///< the picture is the first one's skin, u to the right and v up, both from 0 to 1
};

/// Returns the first body at the origin, and in the view of the flock the others behind it.
Scene scene_of(const Settings& settings, const Body& body);

}  // namespace relief::moving_frames
