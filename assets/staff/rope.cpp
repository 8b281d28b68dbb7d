#include "assets/staff/rope.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/library/mesh/shapes.h"
#include "framework/library/mesh/tangents.h"
#include "framework/staff/reference/bake.h"

namespace relief {
namespace {

constexpr float ring_radius = 0.7f, tube_radius = 0.22f;

/// Height of the strands above the tube, and its derivatives by u and v.
struct StrandHeight {
    double height, by_u, by_v;
};
StrandHeight strands_at(glm::dvec2 uv) {
    constexpr double around = glm::two_pi<double>(), deep = 0.075, thin = 0.004;
    // Three strands make 12 turns; their fibres wind the other way.
    const double strand = around * (12 * uv.x + 3 * uv.y) / 2, fibre = around * (72 * uv.x - 12 * uv.y);
    const double across = std::cos(strand), round = std::sqrt(across * across + 0.01);
    const double by_strand = -deep * across * std::sin(strand) / round, by_fibre = -thin * std::sin(fibre);
    return {deep * (round - 0.6) + thin * std::cos(fibre), around * (6 * by_strand + 72 * by_fibre),
            around * (1.5 * by_strand - 12 * by_fibre)};
}

/// Turns a ring that lies on the ground so that it faces +z.
Mesh upright(Mesh mesh) {
    const auto turned = [](const glm::vec3& v) { return glm::vec3(v.x, -v.z, v.y); };
    for (Vertex& vertex : mesh.vertices) {
        vertex.position = turned(vertex.position), vertex.normal = turned(vertex.normal);
        vertex.tangent = glm::vec4(turned(vertex.tangent), vertex.tangent.w);
    }
    return mesh;
}

}  // namespace

Mesh make_coarse_rope() {
    return with_tangents(
        upright(make_torus({.ring_radius = ring_radius, .tube_radius = tube_radius, .sides = 24, .rows = 8})),
        TangentMethod::mikktspace);
}

Mesh make_fine_rope() {
    Mesh mesh = make_torus({.ring_radius = ring_radius, .tube_radius = tube_radius, .sides = 1024, .rows = 192});
    for (Vertex& vertex : mesh.vertices) {
        const glm::dvec3 normal(vertex.normal), tangent(vertex.tangent);
        const glm::dvec3 bitangent = double(vertex.tangent.w) * glm::cross(normal, tangent);
        const glm::dvec2 from_axis(vertex.position.x, vertex.position.z);
        const double radius = glm::length(from_axis),
                     outwards = glm::dot(glm::dvec2(normal.x, normal.z), from_axis) / radius;
        const auto [height, by_u, by_v] = strands_at(vertex.uv);
        // The derivatives of p + h n: those of a circle about the axis, and of one about the tube.
        const glm::dvec3 du = glm::two_pi<double>() * (radius + height * outwards) * tangent + by_u * normal,
                         dv = glm::two_pi<double>() * (double(tube_radius) + height) * bitangent + by_v * normal;
        vertex.position += glm::vec3(height * normal);
        vertex.normal = glm::normalize(glm::cross(du, dv));
    }
    return upright(std::move(mesh));
}

Image bake_rope() {
    Image map = bake(make_fine_rope(), make_coarse_rope(), {.size = {768, 192}, .reach = 0.15}).values;
    for (float& value : map.values) value = 0.5f * value + 0.5f;
    map.bits = 8;
    return map;
}

}  // namespace relief
