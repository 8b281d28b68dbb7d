// The patches of lab 09's planet: where their grids lie, what encloses them, and which of them a picture needs.
#pragma once

#include <span>
#include <vector>

#include "framework/lab/lab.h"
#include "heights.h"

namespace relief::planet {

enum class Mapping : int { equal_angle, gnomonic, lat_long };

constexpr int deepest_level = 12;

/// A patch of a level: one of 2^level x 2^level on its face.
struct PatchId {
    int face = 0, level = 0, x = 0, y = 0;
    auto operator<=>(const PatchId&) const = default;
    /// (0, 0) to (1, 1) on the patch; -1 to 1 on its face.
    glm::dvec2 on_face(glm::dvec2 local) const {
        const double width = 2.0 / (1 << level);  // a power of 2: neighbours agree to the last bit
        return width * (glm::dvec2(x, y) + local) - 1.0;
    }
};

/// A cube has six faces, latitude and longitude two halves.
inline int face_count(Mapping mapping) { return mapping == Mapping::lat_long ? 2 : 6; }
/// Columns: right, up, out.
glm::dmat3 face_axes(Mapping mapping, int face);
/// Of unit length; places on the border of two faces agree to the last bit.
glm::dvec3 direction_at(Mapping mapping, int face, glm::dvec2 st);

/// The planet's shape: all that the patches' vertices depend on.
struct Shape {
    Ground ground;
    Mapping mapping = Mapping::equal_angle;
    int quads = 16;  ///< along a patch's side
    bool operator==(const Shape&) const = default;
};

/// How far the triangles of each level are from the ground, and how high that is: in radii, from some thousand places.
struct Measured {
    std::array<double, deepest_level + 1> errors{};        ///< at most, with a margin
    std::array<double, deepest_level + 1> usual_errors{};  ///< at nine of ten places
    double highest = 0;                                    ///< of the ground, above the radius; the lowest is 0
};
const Measured& measured(const Shape& shape);

/// What encloses a patch, in radii: a ball around its ground, and the widest angle from its middle's direction.
struct Bounds {
    glm::dvec3 direction, middle;
    double angle, radius, highest;
};
Bounds bounds_of(const Shape& shape, const PatchId& id);

/// An eye near a planet of radius 1 at the origin.
struct Eye {
    glm::dvec3 place{0, 0, 3};
    glm::dmat3 view_from_world{1};  ///< turns only
    double field_of_view_rad = 0.7, aspect = 1;

    static Eye of(const Camera& camera, double aspect);
    /// Upright at `place` with a direction of sight.
    static Eye looking(const glm::dvec3& place, const glm::dvec3& along, const glm::dvec3& up, double field_of_view_rad,
                       double aspect);
    /// x and y in [-1, 1]; of unit length.
    Ray ray(glm::dvec2 clip) const;
};

enum class Levels : int { uniform, distance, error };
enum class Cull : int { none, outside, horizon };

/// What decides which patches a picture needs.
struct Plan {
    Shape shape;
    Levels levels = Levels::error;
    int level = 3;      ///< of every patch, for Levels::uniform
    double budget = 1;  ///< pixels
    Cull cull = Cull::horizon;
    double radius = 1;  ///< metres
    bool skirts = true;
    double pixels = 512;  ///< height of the picture
    Eye eye;
};

struct Leaf {
    enum State { drawn, outside, hidden, gone };
    PatchId id;
    State state = drawn;
};

/// What students write in task.cpp.
struct Rules {
    double (*split_distance)(double, double, double, double);
    double (*skirt_depth)(std::span<const double>, int);
    bool (*behind_horizon)(double, double, double, double);
};
Rules students_rules();

/// Whether a ball lies wholly beside the picture, or behind the eye.
bool is_outside(const Eye& eye, const glm::dvec3& middle, double radius);

/// All of the planet in patches; those that need not be drawn as large as possible. Neighbours that are drawn differ by
/// one level at most.
std::vector<Leaf> leaves(const Plan& plan, const Rules& rules = students_rules());
/// The place of a direction: its face, and s and t there.
std::pair<int, glm::dvec2> face_place(Mapping mapping, const glm::dvec3& direction);

}  // namespace relief::planet
