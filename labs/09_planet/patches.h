// The patches of lab 09's planet: their grids, their bounds, and the patches that a picture needs.
#pragma once

#include <span>
#include <vector>

#include "framework/lab/lab.h"
#include "heights.h"

namespace relief::planet {

enum class Mapping : int { equal_angle, gnomonic, lat_long };

constexpr int deepest_level = 12;

/// A patch: one of 2^level x 2^level on its face.
struct PatchId {
    int face = 0, level = 0, x = 0, y = 0;
    auto operator<=>(const PatchId&) const = default;
    /// Returns the place on the face, each coordinate in [-1, 1], of a place on the patch from (0, 0) to (1, 1).
    glm::dvec2 on_face(glm::dvec2 local) const {
        const double width = 2.0 / (1 << level);  // a power of 2: neighbours agree to the last bit
        return width * (glm::dvec2(x, y) + local) - 1.0;
    }
};

/// Returns 6 for the faces of a cube, or 2 for the halves of latitude and longitude.
inline int face_count(Mapping mapping) { return mapping == Mapping::lat_long ? 2 : 6; }
/// Returns the axes of a face as columns: right, up, out.
glm::dmat3 face_axes(Mapping mapping, int face);
/// Returns the unit direction of the place `st` on a face, each coordinate in [-1, 1] or somewhat beyond. Two faces
/// agree on their common border to the last bit.
glm::dvec3 direction_at(Mapping mapping, int face, glm::dvec2 st);

/// The shape of the planet: everything that the vertices of patches depend on.
struct Shape {
    Ground ground;
    Mapping mapping = Mapping::equal_angle;
    int quads = 16;  ///< along a patch's side
    bool operator==(const Shape&) const = default;
};

/// The errors of the triangles of each level, and the highest ground, in radii. Estimated from some thousand samples.
struct Measured {
    std::array<double, deepest_level + 1> errors{};        ///< the largest error, with a margin
    std::array<double, deepest_level + 1> usual_errors{};  ///< upper bound at nine of ten places
    double highest = 0;                                    ///< the highest ground, with a margin; the lowest is 0
};
/// Returns the measured errors, cached by shape. Thread-safe. The first call for a shape takes longer than a frame.
const Measured& measured(const Shape& shape);

/// Bounds of the ground of a patch, in radii of the planet. `direction` is the unit direction of the patch's middle,
/// and `angle` the largest angle in radians between it and the direction of a place on the patch. `middle` and `radius`
/// are a bounding sphere. `highest` is an upper bound of the heights.
struct Bounds {
    glm::dvec3 direction, middle;
    double angle, radius, highest;
};
/// Returns the bounds of a patch, cached. Thread-safe.
Bounds bounds_of(const Shape& shape, const PatchId& id);

/// An eye near a planet of radius 1 at the origin.
struct Eye {
    glm::dvec3 place{0, 0, 3};
    glm::dmat3 view_from_world{1};  ///< a rotation
    double field_of_view_rad = 0.7, aspect = 1;

    static Eye of(const Camera& camera, double aspect);
    /// Returns an eye at `place` that looks along the unit vector `along`, with `up` upwards in the picture.
    static Eye looking(const glm::dvec3& place, const glm::dvec3& along, const glm::dvec3& up, double field_of_view_rad,
                       double aspect);
    /// Returns the ray of unit direction through a place of the picture, with x and y in [-1, 1].
    Ray ray(glm::dvec2 clip) const;
};

enum class Levels : int { uniform, distance, error };
enum class Cull : int { none, outside, horizon };

/// The input of leaves(): everything that decides which patches a picture needs.
struct Plan {
    Shape shape;
    Levels levels = Levels::error;
    int level = 3;      ///< for Levels::uniform: level of all patches
    double budget = 1;  ///< tolerated error, pixels
    Cull cull = Cull::horizon;
    double radius = 1;  ///< metres
    bool skirts = true;
    double pixels = 512;  ///< height of the picture
    Eye eye;
    size_t most_patches = 6144;  ///< at least 6, one per face; patches with the greatest need are split first
};

struct Leaf {
    enum State { drawn, outside, hidden, gone };  // `gone` is internal to leaves()
    PatchId id;
    State state = drawn;
};

/// The functions of task.h, which students write.
struct Rules {
    double (*split_distance)(double, double, double, double);
    double (*skirt_depth)(std::span<const double>, int);
    bool (*behind_horizon)(double, double, double, double);
};
Rules students_rules();

/// Returns whether a sphere is wholly outside of the picture or behind the eye. Conservative: may return false.
bool is_outside(const Eye& eye, const glm::dvec3& middle, double radius);

/// Patches that cover the whole planet. A culled patch is as large as possible. Drawn neighbours differ by one level at
/// most.
struct Cover {
    std::vector<Leaf> leaves;
    bool is_bounded = false;  ///< most_patches has reduced the number of patches
};
Cover cover(const Plan& plan, const Rules& rules = students_rules());
inline std::vector<Leaf> leaves(const Plan& plan, const Rules& rules = students_rules()) {
    return cover(plan, rules).leaves;
}
/// Returns the face of a unit direction, and s and t on it. The inverse of direction_at().
std::pair<int, glm::dvec2> face_place(Mapping mapping, const glm::dvec3& direction);

}  // namespace relief::planet
