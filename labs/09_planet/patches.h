// The patches of lab 09's planet that a picture needs.
#pragma once

#include <span>
#include <vector>

#include "eye.h"
#include "framework/library/kit/choices.h"
#include "heights.h"
#include "sphere_patches.h"

namespace relief::planet {

/// The shape of the planet: everything that the vertices of patches depend on.
struct Shape {
    Ground ground;
    SphereMapping mapping = SphereMapping::equal_angle;
    int quads = 16;  ///< along a patch's side
    bool operator==(const Shape&) const = default;

    /// Returns the ground at a unit direction, in radii.
    glm::dvec3 place(const glm::dvec3& r) const { return (1 + height(ground, r)) * r; }
};

/// Returns the errors and bounds of the planet's patches, cached by shape. Thread-safe. The first call for a shape
/// takes longer than a frame.
const PatchedSphere& patches_of(const Shape& shape);

enum class Levels : int { uniform, distance, error };
inline constexpr auto level_rules =
    choices<Levels>({{Levels::uniform, "uniform"}, {Levels::distance, "distance"}, {Levels::error, "error"}});
enum class Cull : int { none, outside, horizon };
inline constexpr auto culls =
    choices<Cull>({{Cull::none, "none"}, {Cull::outside, "outside"}, {Cull::horizon, "horizon"}});

/// The input of cover(): everything that decides which patches a picture needs.
struct Plan {
    Shape shape;
    Levels levels = Levels::error;
    int level = 3;      ///< for Levels::uniform: level of all patches
    double budget = 1;  ///< tolerated error, pixels
    Cull cull = Cull::horizon;
    double radius = 1;  ///< metres
    bool skirts = true;
    double pixels = 512;         ///< height of the picture
    Eye eye;                     ///< near a planet of radius 1 at the origin
    size_t most_patches = 6144;  ///< at least 6, one per face; patches with the greatest need are split first
};

/// The functions of task.h, which students write.
struct Rules {
    double (*split_distance)(double, double, double, double);
    double (*skirt_depth)(std::span<const double>, int);
    bool (*behind_horizon)(double, double, double, double);
};
Rules students_rules();

/// Returns patches that cover the whole planet, and which of them the picture shows.
Cover cover(const Plan& plan, const Rules& rules = students_rules());

}  // namespace relief::planet
