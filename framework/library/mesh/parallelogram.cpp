#include "framework/library/mesh/parallelogram.h"

namespace relief {

PlaneAxes plane_axes(const glm::dvec3& normal) {
    const glm::dvec3 across = glm::cross(glm::dvec3(0, 1, 0), normal);
    const double sine = glm::length(across);
    const glm::dvec3 right = sine > 1e-6 ? across / sine : glm::dvec3(1, 0, 0);
    return {right, glm::cross(normal, right)};
}

Mesh make_parallelogram(const Parallelogram& shape) {
    Mesh mesh;
    const glm::dvec3 normal = glm::normalize(glm::cross(shape.right, shape.up));
    const PlaneAxes axes = plane_axes(normal);
    const int cells = shape.cells;
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const glm::dvec3 place =
                shape.corner + shape.right * (double(column) / cells) + shape.up * (double(row) / cells);
            mesh.vertices.push_back({place, normal, glm::vec4(axes.right, 1),
                                     glm::dvec2(glm::dot(place, axes.right), glm::dot(place, axes.up)) / shape.tile});
        }
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const auto a = uint32_t(row * (cells + 1) + column), b = a + 1, c = a + uint32_t(cells) + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, c + 1, a, c + 1, c});
        }
    return mesh;
}

Mesh make_block(const glm::dvec3& low, const glm::dvec3& high, double tile) {
    Mesh mesh;
    const glm::dvec3 middle = (low + high) / 2.0, reach = (high - low) / 2.0;
    for (int side = 0; side < 6; ++side) {
        glm::dvec3 normal(0);
        normal[side / 2] = side % 2 == 0 ? 1 : -1;
        const PlaneAxes axes = plane_axes(normal);
        const glm::dvec3 right = axes.right * reach, up = axes.up * reach;
        append(
            mesh,
            make_parallelogram(
                {.corner = middle + normal * reach - right - up, .right = 2.0 * right, .up = 2.0 * up, .tile = tile}));
    }
    return mesh;
}

void append(Mesh& mesh, const Mesh& part, const glm::dvec3& offset, const glm::vec2& tiles) {
    const auto first = uint32_t(mesh.vertices.size());
    for (Vertex vertex : part.vertices) {
        vertex.position = glm::vec3(glm::dvec3(vertex.position) + offset);
        vertex.uv *= tiles;
        mesh.vertices.push_back(vertex);
    }
    for (const uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

}  // namespace relief
