// The functions that task.cpp of lab 08 defines: what a bump map holds, and in which order surfaces are drawn.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "framework/image/image.h"

namespace relief::materials {

enum class MapKind { heights, normals, neither };

/// The first three channels of a texel, of a picture that has as many.
inline glm::vec3 color_of(const Image& image, size_t texel) {
    const float* const values = &image.values[texel * size_t(image.channels)];
    return {values[0], values[1], values[2]};
}

/// What a picture with 1 to 4 channels in [0, 1] holds.
MapKind kind_of(const Image& image);

/// What draw_order() knows of a surface.
struct Surface {
    int program;          ///< the surfaces with the same number share a program
    bool is_transparent;  ///< what lies behind it shows through
    glm::dvec3 centre;
};

/// The order in which surfaces are drawn, as indices into `surfaces`: each of them once.
std::vector<int> draw_order(std::span<const Surface> surfaces, const glm::dvec3& eye);

}  // namespace relief::materials
