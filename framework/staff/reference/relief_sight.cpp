#include "framework/staff/reference/relief_sight.h"

#include <algorithm>
#include <limits>

namespace relief {

ReliefSights::ReliefSights(const Mesh& mesh) : mesh_(mesh) {
    const auto position = [&](size_t i) { return glm::dvec3(mesh.vertices[mesh.indices[i]].position); };
    for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
        triangles_.push_back({position(i), position(i + 1) - position(i), position(i + 2) - position(i)});
}

std::optional<ReliefSight> ReliefSights::look(const Ray& ray, const ReliefMapping& mapping, double begin,
                                              bool front_only) const {
    double nearest = std::numeric_limits<double>::infinity();
    size_t seen = 0;
    glm::dvec3 shares{};
    for (size_t i = 0; i < triangles_.size(); ++i) {
        const auto& [corner, e1, e2] = triangles_[i];
        const glm::dvec3 across = glm::cross(ray.direction, e2), from = ray.origin - corner;
        const double determinant = glm::dot(e1, across), s = glm::dot(from, across);
        if (front_only && determinant < 0) continue;
        // Most triangles end here, without a division.
        if (determinant == 0 || s * determinant < 0 || std::abs(s) > std::abs(determinant)) continue;
        const glm::dvec3 q = glm::cross(from, e1);
        const double t = glm::dot(ray.direction, q);
        if (t * determinant < 0 || std::abs(s + t) > std::abs(determinant)) continue;
        const double distance = glm::dot(e2, q) / determinant;
        if (distance <= begin || distance >= nearest) continue;
        nearest = distance, seen = i, shares = {1 - (s + t) / determinant, s / determinant, t / determinant};
    }
    if (nearest == std::numeric_limits<double>::infinity()) return {};

    ReliefSight sight{};
    sight.distance = nearest, sight.position = ray.at(nearest);
    glm::dvec3 tangent(0);
    glm::dvec2 uv(0);
    double handedness = 1;
    for (int i = 0; i < 3; ++i) {
        const Vertex& vertex = mesh_.vertices[mesh_.indices[seen * 3 + size_t(i)]];
        sight.normal += shares[i] * glm::dvec3(vertex.normal);
        tangent += shares[i] * glm::dvec3(vertex.tangent);
        uv += shares[i] * glm::dvec2(vertex.uv);
        handedness = double(vertex.tangent.w);
    }
    const double side = mapping.repeat.x < 0 ? -1 : 1;
    sight.normal = glm::normalize(sight.normal);
    sight.tangent = side * glm::normalize(tangent - glm::dot(tangent, sight.normal) * sight.normal);
    sight.bitangent = side * handedness * glm::cross(sight.normal, sight.tangent);
    sight.uv = uv * glm::dvec2(mapping.repeat) + glm::dvec2(mapping.shift);

    const glm::dvec3 to_eye = -ray.direction;
    const double cosine = glm::dot(to_eye, sight.normal);
    sight.faces_away = cosine <= 0;
    sight.ray.slant = std::max(cosine, least_slant);
    sight.ray.texel = sight.uv * double(mapping.texels);
    sight.ray.march = -glm::dvec2(glm::dot(to_eye, sight.tangent), glm::dot(to_eye, sight.bitangent)) /
                      sight.ray.slant * glm::dvec2(mapping.depth) * double(mapping.texels);
    sight.metres_to_ground = double(mapping.metres) / sight.ray.slant;
    return sight;
}

}  // namespace relief
