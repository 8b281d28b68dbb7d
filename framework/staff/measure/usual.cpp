#include "framework/staff/measure/usual.h"

#include <cmath>

namespace relief::measure {

void usual_tangents(const Mesh& mesh, std::vector<glm::vec3>& sums, std::vector<glm::vec4>& tangents) {
    const size_t count = mesh.vertices.size();
    sums.assign(2 * count, glm::vec3(0));
    tangents.resize(count);
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vertex &a = mesh.vertices[mesh.indices[i]], &b = mesh.vertices[mesh.indices[i + 1]],
                     &c = mesh.vertices[mesh.indices[i + 2]];
        const glm::vec3 edge1 = b.position - a.position, edge2 = c.position - a.position;
        const glm::vec2 uv1 = b.uv - a.uv, uv2 = c.uv - a.uv;
        const float r = 1 / (uv1.x * uv2.y - uv2.x * uv1.y);
        const glm::vec3 along_u = (edge1 * uv2.y - edge2 * uv1.y) * r, along_v = (edge2 * uv1.x - edge1 * uv2.x) * r;
        for (size_t k = 0; k < 3; ++k)
            sums[mesh.indices[i + k]] += along_u, sums[count + mesh.indices[i + k]] += along_v;
    }
    for (size_t i = 0; i < count; ++i) {
        const glm::vec3 normal = mesh.vertices[i].normal, sum = sums[i];
        tangents[i] = glm::vec4(glm::normalize(sum - normal * glm::dot(normal, sum)),
                                glm::dot(glm::cross(normal, sum), sums[count + i]) < 0 ? -1 : 1);
    }
}

void usual_normals(const Image& heights, double texels, Image& normals) {
    const auto height = [&](int x, int y) {
        return *heights.pixel((x + heights.width) % heights.width, (y + heights.height) % heights.height);
    };
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) {
            const float left = height(x - 1, y - 1) + 2 * height(x - 1, y) + height(x - 1, y + 1);
            const float right = height(x + 1, y - 1) + 2 * height(x + 1, y) + height(x + 1, y + 1);
            const float above = height(x - 1, y - 1) + 2 * height(x, y - 1) + height(x + 1, y - 1);
            const float below = height(x - 1, y + 1) + 2 * height(x, y + 1) + height(x + 1, y + 1);
            const glm::vec3 normal =
                glm::normalize(glm::vec3((left - right) * float(texels) / 8, (below - above) * float(texels) / 8, 1));
            for (int i = 0; i < 3; ++i) normals.pixel(x, y)[i] = 0.5f * normal[i] + 0.5f;
        }
}

Image normals_of_slopes(const Image& slopes, double texels) {
    Image normals(slopes.width, slopes.height, 3);
    for (int y = 0; y < slopes.height; ++y)
        for (int x = 0; x < slopes.width; ++x) {
            const float* const slope = slopes.pixel(x, y);
            const glm::dvec3 normal = glm::normalize(glm::dvec3(-slope[0] * texels, slope[1] * texels, 1));
            for (int i = 0; i < 3; ++i) normals.pixel(x, y)[i] = float(0.5 * normal[i] + 0.5);
        }
    return normals;
}

NormalCode usual_code(const glm::dvec3& normal) {
    NormalCode code{};
    for (int i = 0; i < 3; ++i) code.channel[size_t(i)] = uint16_t((0.5 * normal[i] + 0.5) * 255);
    return code;
}
glm::dvec3 usual_normal(const NormalCode& code) {
    return glm::normalize(glm::dvec3(code.channel[0], code.channel[1], code.channel[2]) / 255.0 * 2.0 - 1.0);
}

}  // namespace relief::measure
