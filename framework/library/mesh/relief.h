// How a relief is mapped to a mesh, and the inputs of its shaders at each vertex.
#pragma once

#include <glm/glm.hpp>

namespace relief {

/// One tile of the height map is one unit of the map's texture coordinates: uv = vertex uv * repeat + shift. Tangents
/// point along growing map u, so a negative repeat.x reverses them and their handedness.
struct ReliefMapping {
    glm::vec2 repeat = {1, 1};       ///< tiles per unit of the mesh's uv; a negative x mirrors the map
    glm::vec2 shift = {0, 0};        ///< tiles
    glm::vec2 depth = {0.08, 0.08};  ///< a height of 1, in tiles along u and along v
    float metres = 0.08f;            ///< a height of 1, in metres
    int texels = 512;                ///< of the map along each side
    bool operator==(const ReliefMapping&) const = default;
};

}  // namespace relief
