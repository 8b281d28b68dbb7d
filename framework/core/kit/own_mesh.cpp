#include "framework/core/kit/own_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/mesh/shapes.h"
#include "framework/core/mesh/uv_tangents.h"

namespace relief {
namespace {

/// Returns the cross product of two sides, whose length is twice the triangle's area.
glm::dvec3 twice_area(const Mesh& mesh, size_t first_index) {
    const auto corner = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[first_index + i]].position); };
    return glm::cross(corner(1) - corner(0), corner(2) - corner(0));
}

/// Sets uv in units of `side`, from 0 at the lower left corner of each side of the bounding box. A vertex of triangles
/// that are projected along different axes becomes several vertices.
Mesh with_projected_uv(const Mesh& mesh, const glm::dvec3& half, double side) {
    constexpr uint32_t unused = ~0u;
    constexpr std::array<uint32_t, 6> none = {unused, unused, unused, unused, unused, unused};
    std::vector<std::array<uint32_t, 6>> copies(mesh.vertices.size(), none);  // by the face of the box
    Mesh result;
    result.indices.reserve(mesh.indices.size());
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec3 normal = twice_area(mesh, i), size = glm::abs(normal);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const int face = 2 * axis + (normal[axis] < 0);
        const auto& [out, right, up] = cube_face(face);
        for (size_t k = 0; k < 3; ++k) {
            uint32_t& copy = copies[mesh.indices[i + k]][size_t(face)];
            if (copy == unused) {
                copy = uint32_t(result.vertices.size());
                Vertex vertex = mesh.vertices[mesh.indices[i + k]];
                const glm::dvec3 position(vertex.position);
                vertex.uv = glm::dvec2(glm::dot(position, right) + glm::dot(half, glm::abs(right)),
                                       glm::dot(position, up) + glm::dot(half, glm::abs(up))) /
                            side;
                result.vertices.push_back(vertex);
            }
            result.indices.push_back(copy);
        }
    }
    return result;
}

}  // namespace

Mesh prepared_model(ObjModel model, double radius) {
    glm::dvec3 low(INFINITY), high(-INFINITY);
    for (const uint32_t index : model.mesh.indices) {
        const glm::dvec3 position(model.mesh.vertices[index].position);
        low = glm::min(low, position), high = glm::max(high, position);
    }
    const glm::dvec3 middle = 0.5 * (low + high);
    const double half_diagonal = glm::length(0.5 * (high - low));
    bool has_area = false;
    for (size_t i = 0; i < model.mesh.indices.size() && !has_area; i += 3)
        has_area = glm::length(twice_area(model.mesh, i)) > 0;
    if (!has_area) throw Error("has no area: the corners of each triangle lie on a line");
    const double scale = radius / half_diagonal;
    for (Vertex& vertex : model.mesh.vertices) vertex.position = scale * (glm::dvec3(vertex.position) - middle);
    if (model.has_uvs) return std::move(model.mesh);
    const glm::dvec3 half = 0.5 * scale * (high - low);
    return with_projected_uv(model.mesh, half, 2 * std::max({half.x, half.y, half.z}));
}

Mesh with_face_tangents(const Mesh& mesh) {
    Mesh corners;
    corners.vertices.reserve(mesh.indices.size()), corners.indices.reserve(mesh.indices.size());
    for (const uint32_t index : mesh.indices) {
        corners.indices.push_back(uint32_t(corners.vertices.size()));
        corners.vertices.push_back(mesh.vertices[index]);
    }
    set_uv_tangents(corners);
    return corners;
}

double metres_per_uv(const Mesh& mesh) {
    double area = 0, in_uv = 0;
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto uv = [&](size_t k) { return glm::dvec2(mesh.vertices[mesh.indices[i + k]].uv); };
        const glm::dvec2 along = uv(1) - uv(0), across = uv(2) - uv(0);
        area += glm::length(twice_area(mesh, i)), in_uv += std::abs(along.x * across.y - along.y * across.x);
    }
    const double side = std::sqrt(area / in_uv);
    return std::isfinite(side) && side > 0 ? side : 1;
}

void OwnMesh::load(const std::filesystem::path& file) {
    ObjModel model = read_obj(file, limits);
    try {
        mesh_ = prepared_model(std::move(model), radius_);
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
}

}  // namespace relief
