#include "scene.h"

#include <cmath>

#include "framework/library/mesh/shapes.h"

namespace relief::layered_normals {
namespace {

/// Returns the distance of the rock's surface from its centre in a unit direction.
double rock_radius(const glm::dvec3& direction) {
    const auto outside = [&](double radius) {
        double value = radius * radius - 1;
        for (const glm::dvec4& wave : lumps)
            value += lump * std::sin(radius * glm::dot(glm::dvec3(wave), direction) + wave.w);
        return value > 0;
    };
    double low = 0, high = 2;
    for (int i = 0; i < 40; ++i) (outside((low + high) / 2) ? high : low) = (low + high) / 2;
    return low;
}

}  // namespace

Surface surface_at(const glm::dvec3& place, bool is_rock) {
    glm::dvec3 outward = 2.0 * place;
    glm::dmat3 bend(2);
    if (is_rock)
        for (const glm::dvec4& wave : lumps) {
            const glm::dvec3 k(wave);
            const double angle = glm::dot(k, place) + wave.w;
            outward += lump * std::cos(angle) * k;
            bend -= lump * std::sin(angle) * glm::outerProduct(k, k);
        }
    const glm::dvec3 normal = glm::normalize(outward);
    return {normal, bend * (glm::dmat3(1) - glm::outerProduct(normal, normal)) / glm::length(outward)};
}

Mesh solid_mesh(int shape) {
    if (shape == Settings::cube) return make_box({.size = glm::vec3(1.5f)});
    Mesh mesh = make_cube_sphere({.radius = 1, .cells = 48});
    if (shape == Settings::rock)
        for (Vertex& vertex : mesh.vertices) {
            const glm::dvec3 direction = glm::normalize(glm::dvec3(vertex.position));
            vertex.position = glm::vec3(rock_radius(direction) * direction);
        }
    return mesh;
}

}  // namespace relief::layered_normals
