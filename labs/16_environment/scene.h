// The scenes of lab 16, as shapes with exact ray intersections, and as triangles.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "framework/core/base/mesh.h"

namespace relief::court {

/// The texture set of a surface. Each is drawn by one call.
enum class Material { floor, brick, stone, marble };
constexpr int materials = 4;
constexpr double marble_gloss = 0.9;
/// Width in metres of a tile of each material's maps. On columns and balls of marble a tile goes once around.
constexpr std::array<double, materials> tile_of = {2, 1, 2, 1.9};

/// Axis-aligned.
struct Box {
    glm::dvec3 low, high;
    Material material;
};
/// Upright, without its ends.
struct Column {
    glm::dvec3 foot;
    double radius, height;
};
struct Ball {
    glm::dvec3 centre;
    double radius;
};
/// A parallelogram that faces cross(right, up).
struct Quad {
    glm::dvec3 corner, right, up;
    Material material;
};

struct Scene {
    std::vector<Box> boxes;
    std::vector<Column> columns;
    std::vector<Ball> balls;
    std::vector<Quad> quads;
    glm::dvec3 low{0}, high{0};  ///< bounding box of the scene
    double reach = 0;            ///< largest distance of an occluder, metres
};

enum class Place { court, groove, plane, board };
/// Returns a scene. `tilt` in degrees is the slope of the groove's walls, clamped to [0, 80], or the plane's rotation
/// about the z axis. The board lies above the plane and casts a shadow on it. The court has no tilt.
Scene make_scene(Place place, double tilt);

/// Returns the triangles of one material. With `displaced` the court's floor is a grid.
Mesh mesh_of(const Scene& scene, Material material, bool displaced);

/// The ground of the court: its height, about -1 to 1, and the derivatives along x and z. Below `water` it is a puddle.
struct Ground {
    double height;
    glm::dvec2 slope;
};
Ground ground_at(const glm::dvec2& place);
/// The waves of the ground: radians per metre along x and z, amplitude, phase in radians.
constexpr int ground_waves = 6;
extern const std::array<glm::dvec4, ground_waves> ground_terms;
constexpr double water = -0.06;
constexpr double rise = 0.075;  ///< metres: the displaced floor is rise * (ground - water)^2 above its puddles
/// Returns the height of the displaced floor in metres, and its derivatives along x and z.
Ground floor_at(const glm::dvec2& place);

}  // namespace relief::court
