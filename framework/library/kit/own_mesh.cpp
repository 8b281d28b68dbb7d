#include "framework/library/kit/own_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "framework/core/base/error.h"
#include "framework/core/image/file.h"
#include "framework/library/maps/own_picture.h"
#include "framework/library/mesh/shapes.h"
#include "framework/library/mesh/tangents.h"

namespace relief {
namespace {

/// Returns the cross product of two sides, whose length is twice the triangle's area.
glm::dvec3 twice_area(const Mesh& mesh, size_t first_index) {
    const auto corner = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[first_index + i]].position); };
    return glm::cross(corner(1) - corner(0), corner(2) - corner(0));
}

struct Bounds {
    glm::dvec3 low, high;
};
Bounds bounds_of(const Mesh& mesh) {
    Bounds bounds{glm::dvec3(INFINITY), glm::dvec3(-INFINITY)};
    for (const uint32_t index : mesh.indices) {
        const glm::dvec3 position(mesh.vertices[index].position);
        bounds.low = glm::min(bounds.low, position), bounds.high = glm::max(bounds.high, position);
    }
    return bounds;
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

/// Returns the picture of a normal map, with its scale in x and y.
Image decoded_normals(const GltfNormalMap& map) {
    Image picture;
    try {
        picture = decode_image(map.picture);
        if (picture.channels < 3) throw Error("is grey: a normal map has three channels");
    } catch (const Error& error) {
        throw Error(std::string("its normal map: ") + error.what());
    }
    picture = channels_of(picture, 0, 3);
    for (size_t i = 0; i < picture.values.size(); i += 3) {
        float* const texel = &picture.values[i];
        glm::dvec3 normal = 2.0 * glm::dvec3(texel[0], texel[1], texel[2]) - 1.0;
        normal.x *= map.scale, normal.y *= map.scale;
        const double length = glm::length(normal);
        const bool is_normal = std::isfinite(length) && length > 0;
        if (is_normal && map.scale == 1) continue;
        for (int c = 0; c < 3; ++c) texel[c] = is_normal ? float(0.5 * normal[c] / length + 0.5) : c == 2 ? 1 : 0.5f;
    }
    return picture;
}

}  // namespace

Placement placement_of(const Mesh& mesh, double radius) {
    bool has_area = false;
    for (size_t i = 0; i < mesh.indices.size() && !has_area; i += 3) has_area = glm::length(twice_area(mesh, i)) > 0;
    if (!has_area) throw Error("has no area: the corners of each triangle lie on a line");
    const auto [low, high] = bounds_of(mesh);
    return {0.5 * (low + high), radius / glm::length(0.5 * (high - low))};
}

Mesh prepared_model(Mesh mesh, bool has_uvs, double radius) {
    const auto [middle, scale] = placement_of(mesh, radius);
    for (Vertex& vertex : mesh.vertices) vertex.position = scale * (glm::dvec3(vertex.position) - middle);
    if (has_uvs) return mesh;
    const auto [low, high] = bounds_of(mesh);
    const glm::dvec3 size = high - low;
    return with_projected_uv(mesh, 0.5 * size, std::max({size.x, size.y, size.z}));
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

Mesh OwnMesh::mesh_with_tangents() const {
    return tangents_follow_uv_ ? mesh_ : with_tangents(mesh_, TangentMethod::mikktspace);
}

std::vector<std::string> OwnMesh::load(const std::filesystem::path& file) {
    Model model = read_model(file);
    if (!model.has_uvs)
        model.notes.push_back(note_about({file}, "has no uv: they are made by projection along the axes"));
    try {
        std::vector<OwnNormalMap> normal_maps;
        for (const GltfNormalMap& map : model.normal_maps)
            normal_maps.push_back({decoded_normals(map), map.wrap_u, map.wrap_v});
        Placement placement = placement_of(model.mesh, radius_);
        placement.middle += model.centre;
        mesh_ = prepared_model(std::move(model.mesh), model.has_uvs, radius_);
        placement_ = placement;
        has_tangents_ = model.has_tangents;
        tangents_follow_uv_ = model.tangents_follow_uv;
        normal_maps_ = std::move(normal_maps), parts_ = std::move(model.parts);
        if (parts_.empty()) parts_ = {{0, uint32_t(mesh_.indices.size())}};
        return std::move(model.notes);
    } catch (const Error& error) {
        throw Error({file}, error.what());
    }
}

}  // namespace relief
