// What stands in lab 16's scenes, in shapes that a ray meets exactly, and as triangles.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "framework/mesh/mesh.h"

namespace relief::court {

/// By which maps a thing is covered: what is drawn together.
enum class Material { floor, brick, stone, marble };
constexpr int materials = 4;
constexpr double marble_gloss = 0.9;
/// Metres that a tile of its maps covers. On marble columns and balls a tile goes once around.
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
    glm::dvec3 low, high;  ///< of all of it
    double reach;          ///< how far occlusion looks, metres
};

enum class Place { court, groove, plane, board };
/// `tilt` in degrees: how steep the walls of the groove are, and how far the plane is turned about the z axis; it lies
/// alone, or under a board.
Scene make_scene(Place place, double tilt);

/// The directions of u and v on a plane that faces `normal`: u to the right seen from outside, v up.
struct Axes {
    glm::dvec3 right, up;
};
Axes axes_of(const glm::dvec3& normal);

/// Triangles of one material. The court's floor is a grid where it is to be displaced.
Mesh mesh_of(const Scene& scene, Material material, bool displaced);

/// The ground of the court, about -1 to 1, and how it changes along x and z. Where it lies below the water there is a
/// puddle.
struct Ground {
    double height;
    glm::dvec2 slope;
};
Ground ground_at(const glm::dvec2& place);
/// The waves of the ground: how many radians a metre along x and z, amplitude, phase.
constexpr int ground_waves = 6;
extern const std::array<glm::dvec4, ground_waves> ground_terms;
constexpr double water = -0.06;
constexpr double rise = 0.075;  ///< metres: the displaced floor stands rise * (ground - water)^2 above its puddles
double floor_height(const glm::dvec2& place);

/// The evening sky in a direction of unit length, in linear light; the sun stands over +z.
glm::dvec3 sky(const glm::dvec3& direction);
/// The sky is a sum of these: color exp(sharpness (dot(direction, middle) - 1)).
struct Lobe {
    glm::dvec3 color;
    double sharpness;
    glm::dvec3 middle;
};
const std::vector<Lobe>& sky_lobes();

}  // namespace relief::court
