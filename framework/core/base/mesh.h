// An indexed triangle mesh with everything that surface detail needs at a vertex.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace relief {

/// `normal` and `tangent.xyz` are perpendicular unit vectors. bitangent = tangent.w * cross(normal, tangent.xyz), where
/// tangent.w is 1, or -1 where the uv are mirrored.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec4 tangent;
    glm::vec2 uv;
};

/// Three indices per triangle, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
};

}  // namespace relief
