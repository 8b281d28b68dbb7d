#include "scene.h"

#include <algorithm>
#include <cmath>

#include "framework/mesh/shapes.h"

namespace relief::court {
namespace {

constexpr double half = 7;  // half of the court's width, metres

Scene make_court() {
    using enum Material;
    Scene scene;
    scene.quads = {{{-half, 0, half}, {2 * half, 0, 0}, {0, 0, -2 * half}, floor}};
    scene.boxes = {
        {{-7.4, 0, -7.4}, {-7, 3.1, 5}, brick},           // the wall on the left
        {{-7.5, 3.1, -7.5}, {-6.86, 3.28, 5.1}, stone},   // its coping
        {{-7, 0, -7.3}, {7, 0.42, -6.9}, brick},          // the parapet behind
        {{-7, 0.42, -7.38}, {7, 0.52, -6.82}, stone},     //
        {{7, 0, -7.3}, {7.4, 0.42, 6}, brick},            // and on the right
        {{6.92, 0.42, -7.38}, {7.48, 0.52, 6.1}, stone},  //
        {{-6.4, 0, -5.9}, {6.4, 0.16, -4.3}, stone},      // the step under the columns
        {{-6, 3.74, -5.42}, {6, 4.2, -4.78}, stone},      // the beam on the columns
        {{-6.1, 4.2, -5.52}, {6.1, 4.32, -4.68}, stone},  //
        {{-7, 0, -3.2}, {-6.35, 0.46, 1.2}, stone},       // a bench
        {{1.35, 0, -1.65}, {2.45, 0.16, -0.55}, stone},   // the ball's foot
        {{1.55, 0.16, -1.45}, {2.25, 0.62, -0.75}, stone},
    };
    for (const double x : {-5.2, -2.6, 0.0, 2.6, 5.2}) {
        scene.boxes.push_back({{x - 0.44, 0.16, -5.54}, {x + 0.44, 0.42, -4.66}, stone});
        scene.boxes.push_back({{x - 0.4, 3.56, -5.5}, {x + 0.4, 3.74, -4.7}, stone});
        scene.columns.push_back({{x, 0.42, -5.1}, 0.3, 3.14});
    }
    scene.balls = {{{1.9, 1.14, -1.1}, 0.52}};
    scene.low = {-7.5, 0, -7.5}, scene.high = {7.5, 4.32, 7};
    scene.reach = 1.6;
    return scene;
}

// Two walls that meet along the z axis, long enough to count as infinite.
Scene make_groove(double tilt) {
    const double steep = std::tan(glm::radians(std::clamp(tilt, 0.0, 80.0)));
    constexpr double length = 60;
    Scene scene;
    scene.quads = {{{-1, steep, length / 2}, {1, -steep, 0}, {0, 0, -length}, Material::marble},
                   {{0, 0, length / 2}, {1, steep, 0}, {0, 0, -length}, Material::marble}};
    scene.low = {-1, 0, -length / 2}, scene.high = {1, steep, length / 2};
    scene.reach = 1000;
    return scene;
}

// A plane, optionally under a board that casts a shadow.
Scene make_plane(double tilt, bool has_board) {
    const double angle = glm::radians(tilt), side = 6;
    const glm::dvec3 right(side * std::cos(angle), side * std::sin(angle), 0), up(0, 0, -side);
    Scene scene;
    scene.quads = {{-(right + up) / 2.0, right, up, Material::marble}};
    if (has_board) scene.boxes = {{{-0.8, 1.2, -0.6}, {0.8, 1.25, 0.6}, Material::stone}};
    scene.low = glm::min(glm::dvec3(-3), scene.low), scene.high = glm::dvec3(3);
    scene.reach = 0.9;
    return scene;
}

/// Adds a quad as a grid of cells x cells. uv are in tiles of its material.
void add_quad(Mesh& mesh, const Quad& quad, int cells) {
    const auto first = uint32_t(mesh.vertices.size());
    const glm::dvec3 normal = glm::normalize(glm::cross(quad.right, quad.up));
    const Axes axes = axes_of(normal);
    const double tile = tile_of[size_t(quad.material)];
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const glm::dvec3 place =
                quad.corner + quad.right * (double(column) / cells) + quad.up * (double(row) / cells);
            mesh.vertices.push_back({place, normal, glm::vec4(axes.right, 1),
                                     glm::dvec2(glm::dot(place, axes.right), glm::dot(place, axes.up)) / tile});
        }
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const uint32_t a = first + uint32_t(row * (cells + 1) + column), b = a + 1, c = a + uint32_t(cells) + 1;
            mesh.indices.insert(mesh.indices.end(), {a, b, c + 1, a, c + 1, c});
        }
}

void add(Mesh& mesh, Mesh part, const glm::dvec3& place, const glm::vec2& tiles) {
    const auto first = uint32_t(mesh.vertices.size());
    for (Vertex& vertex : part.vertices) {
        vertex.position = glm::vec3(glm::dvec3(vertex.position) + place);
        vertex.uv *= tiles;
        mesh.vertices.push_back(vertex);
    }
    for (const uint32_t index : part.indices) mesh.indices.push_back(first + index);
}

}  // namespace

Scene make_scene(Place place, double tilt) {
    return place == Place::court    ? make_court()
           : place == Place::groove ? make_groove(tilt)
                                    : make_plane(tilt, place == Place::board);
}

Axes axes_of(const glm::dvec3& normal) {
    const glm::dvec3 across = glm::cross(glm::dvec3(0, 1, 0), normal);
    const double sine = glm::length(across);
    const glm::dvec3 right = sine > 1e-6 ? across / sine : glm::dvec3(1, 0, 0);
    return {right, glm::cross(normal, right)};
}

Mesh mesh_of(const Scene& scene, Material material, bool displaced) {
    Mesh mesh;
    for (const Quad& quad : scene.quads)
        if (quad.material == material) add_quad(mesh, quad, material == Material::floor && displaced ? 24 : 1);
    for (const Box& box : scene.boxes) {
        if (box.material != material) continue;
        const glm::dvec3 middle = (box.low + box.high) / 2.0, reach = (box.high - box.low) / 2.0;
        for (int side = 0; side < 6; ++side) {
            glm::dvec3 normal(0);
            normal[side / 2] = side % 2 == 0 ? 1 : -1;
            const Axes axes = axes_of(normal);
            const glm::dvec3 right = axes.right * reach, up = axes.up * reach;
            add_quad(mesh, {middle + normal * reach - right - up, 2.0 * right, 2.0 * up, material}, 1);
        }
    }
    if (material != Material::marble) return mesh;
    for (const Column& column : scene.columns)
        add(mesh,
            make_column({.bottom_radius = float(column.radius),
                         .top_radius = float(column.radius),
                         .height = float(column.height),
                         .sides = 28,
                         .rows = 1}),
            column.foot, {1, column.height / tile_of[size_t(material)]});
    for (const Ball& ball : scene.balls)
        add(mesh, make_sphere({.radius = float(ball.radius), .sides = 28, .rows = 14}), ball.centre, {1, 0.5});
    return mesh;
}

const std::array<glm::dvec4, ground_waves> ground_terms = {{{0.62, 0.47, 0.42, 0.4},
                                                            {-0.83, 1.12, 0.33, 2.1},
                                                            {1.71, 0.34, 0.24, 4.4},
                                                            {0.52, -2.13, 0.17, 1.2},
                                                            {2.64, 1.91, 0.10, 5.3},
                                                            {-2.21, 3.05, 0.07, 0.3}}};

Ground ground_at(const glm::dvec2& place) {
    Ground sum{0, {0, 0}};
    for (const glm::dvec4& wave : ground_terms) {
        const double angle = wave.x * place.x + wave.y * place.y + wave.w;
        sum.height += wave.z * std::cos(angle);
        sum.slope -= wave.z * std::sin(angle) * glm::dvec2(wave);
    }
    return sum;
}

Ground floor_at(const glm::dvec2& place) {
    const Ground ground = ground_at(place);
    const double above = std::max(0.0, ground.height - water);
    return {rise * above * above, 2 * rise * above * ground.slope};
}

}  // namespace relief::court
