// An indexed triangle mesh with everything that surface detail needs at a vertex.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace relief {

/// `normal` and `tangent.xyz` are unit and perpendicular; bitangent = tangent.w * cross(normal, tangent.xyz),
/// with tangent.w = 1 or, where the uv are mirrored, -1.
struct Vertex {
    glm::vec3 position;
    glm::vec3 normal;
    glm::vec4 tangent;
    glm::vec2 uv;
};

/// Three indices a triangle, counter-clockwise seen from outside.
struct Mesh {
    std::vector<Vertex> vertices;
    std::vector<uint32_t> indices;
};

}  // namespace relief
