#include "scene.h"

#include <algorithm>
#include <cmath>

#include "framework/library/mesh/parallelogram.h"
#include "framework/library/mesh/shapes.h"

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
    scene.low = glm::dvec3(-3), scene.high = glm::dvec3(3);
    scene.reach = 0.9;
    return scene;
}

}  // namespace

Scene make_scene(Place place, double tilt) {
    return place == Place::court    ? make_court()
           : place == Place::groove ? make_groove(tilt)
                                    : make_plane(tilt, place == Place::board);
}

Mesh mesh_of(const Scene& scene, Material material, bool displaced) {
    Mesh mesh;
    const double tile = tile_of[size_t(material)];
    for (const Quad& quad : scene.quads)
        if (quad.material == material)
            append(mesh, make_parallelogram({.corner = quad.corner,
                                             .right = quad.right,
                                             .up = quad.up,
                                             .cells = material == Material::floor && displaced ? 24 : 1,
                                             .tile = tile}));
    for (const Box& box : scene.boxes)
        if (box.material == material) append(mesh, make_block(box.low, box.high, tile));
    if (material != Material::marble) return mesh;
    for (const Column& column : scene.columns)
        append(mesh,
               make_column({.bottom_radius = float(column.radius),
                            .top_radius = float(column.radius),
                            .height = float(column.height),
                            .sides = 28,
                            .rows = 1}),
               column.foot, {1, column.height / tile});
    for (const Ball& ball : scene.balls)
        append(mesh, make_sphere({.radius = float(ball.radius), .sides = 28, .rows = 14}), ball.centre, {1, 0.5});
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
