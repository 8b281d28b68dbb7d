// The functions that task.cpp of lab 08 defines: the kind of a bump map, and the drawing order of surfaces.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "framework/library/kit/obj_scene.h"

namespace relief::materials {

/// Returns the first three channels of a texel. Precondition: the picture has three or more.
inline glm::vec3 color_of(const Image& image, size_t texel) {
    const float* const values = &image.values[texel * size_t(image.channels)];
    return {values[0], values[1], values[2]};
}

/// Returns the kind of map that a picture with 1 to 4 channels in [0, 1] holds: MapKind::heights, normals or neither.
MapKind kind_of(const Image& image);

/// The input of draw_order() for one surface.
struct Surface {
    int program;          ///< surfaces with the same number share a program
    bool is_transparent;  ///< surfaces behind it are visible through it
    glm::dvec3 centre;
};

/// Returns the order in which surfaces are drawn: a permutation of the indices into `surfaces`.
std::vector<int> draw_order(std::span<const Surface> surfaces, const glm::dvec3& eye);

}  // namespace relief::materials
