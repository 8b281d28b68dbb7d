#include "section.h"

#include <array>

namespace relief {

std::vector<std::pair<glm::dvec3, glm::dvec3>> plane_section(const Mesh& mesh, const glm::dvec3& normal) {
    std::vector<std::pair<glm::dvec3, glm::dvec3>> lines;
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<glm::dvec3, 2> ends;
        size_t count = 0;
        for (size_t k = 0; k < 3 && count < 2; ++k) {
            const glm::dvec3 a = mesh.vertices[mesh.indices[i + k]].position,
                             b = mesh.vertices[mesh.indices[i + (k + 1) % 3]].position;
            const double at_a = glm::dot(a, normal), at_b = glm::dot(b, normal);
            if ((at_a < 0) == (at_b < 0)) continue;
            ends[count++] = glm::mix(a, b, at_a / (at_a - at_b));
        }
        if (count == 2) lines.emplace_back(ends[0], ends[1]);
    }
    return lines;
}

}  // namespace relief
