#include "framework/library/mesh/uv_tangents.h"

#include <array>

namespace relief {

void set_uv_tangents(Mesh& mesh) {
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Vertex* corner[3];
        for (size_t k = 0; k < 3; ++k) corner[k] = &mesh.vertices[mesh.indices[i + k]];
        const glm::dvec3 a = corner[0]->position, b = corner[1]->position, c = corner[2]->position;
        const glm::dvec3 face = glm::cross(b - a, c - a);
        // The gradient of a corner's weight lies across the opposite edge.
        const std::array across = {glm::cross(face, c - b), glm::cross(face, a - c), glm::cross(face, b - a)};
        glm::dvec3 along_u(0), along_v(0);
        for (size_t k = 0; k < 3; ++k)
            along_u += across[k] * double(corner[k]->uv.x), along_v += across[k] * double(corner[k]->uv.y);
        if (glm::dot(along_u, along_u) == 0) continue;
        for (Vertex* vertex : corner) {
            const glm::dvec3 n = vertex->normal, flat = along_u - n * glm::dot(n, along_u);
            if (glm::dot(flat, flat) == 0) continue;
            const double side = glm::dot(glm::cross(n, flat), along_v) < 0 ? -1 : 1;
            vertex->tangent = glm::vec4(glm::normalize(flat), side);
        }
    }
}

}  // namespace relief
