// How a relief lies on a mesh, and the inputs of its shaders at each vertex.
#pragma once

#include <glm/glm.hpp>

namespace relief {

/// A tile of the height map is one unit of the texture coordinates that reach the map: uv = vertex uv * repeat + shift.
/// Tangents are those of growing u, so a negative repeat.x turns them and their handedness.
struct ReliefMapping {
    glm::vec2 repeat = {1, 1};       ///< tiles per unit of the mesh's uv; x is negative where it is mirrored
    glm::vec2 shift = {0, 0};        ///< tiles
    glm::vec2 depth = {0.08, 0.08};  ///< a height of 1, in tiles along u and along v
    float metres = 0.08f;            ///< and in metres
    int texels = 512;                ///< along each side of the map
    bool operator==(const ReliefMapping&) const = default;
};

}  // namespace relief
