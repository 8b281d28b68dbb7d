#include "framework/staff/reference/relief_sight.h"

#include <algorithm>
#include <limits>

#include "framework/staff/reference/mesh_rays.h"

namespace relief {

ReliefSights::ReliefSights(const Mesh& mesh) : mesh_(mesh), tree_(build_tree(mesh)) {}

std::optional<ReliefSight> ReliefSights::look(const Ray& ray, const ReliefMapping& mapping, double begin,
                                              bool front_only) const {
    const Ray drawn{ray.at(begin), ray.direction};
    const auto hit = first_hit(tree_, mesh_, drawn, std::numeric_limits<double>::infinity(), front_only);
    if (!hit) return {};

    ReliefSight sight{};
    sight.distance = begin + hit->t, sight.position = drawn.at(hit->t);
    glm::dvec3 tangent(0);
    glm::dvec2 uv(0);
    double handedness = 1;
    for (int i = 0; i < 3; ++i) {
        const Vertex& vertex = mesh_.vertices[mesh_.indices[size_t(hit->triangle) * 3 + size_t(i)]];
        sight.normal += hit->weights[i] * glm::dvec3(vertex.normal);
        tangent += hit->weights[i] * glm::dvec3(vertex.tangent);
        uv += hit->weights[i] * glm::dvec2(vertex.uv);
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
