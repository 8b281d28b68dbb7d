// Grids on the unit sphere: the six faces of a cube, or two halves by latitude and longitude; and their patches.
#pragma once

#include <compare>
#include <glm/glm.hpp>
#include <utility>

namespace relief {

/// Cubes by equal angles (Ronchi, Iacono and Paolucci 1996) or by projection, and latitude and longitude.
enum class SphereMapping : int { equal_angle, gnomonic, lat_long };

/// Returns 6 for the faces of a cube, or 2 for the halves of latitude and longitude.
inline int face_count(SphereMapping mapping) { return mapping == SphereMapping::lat_long ? 2 : 6; }
/// Returns the axes of a face as columns: right, up, out.
glm::dmat3 face_axes(SphereMapping mapping, int face);
/// Returns the unit direction of the place `st` on a face, each coordinate in [-1, 1] or somewhat beyond. Two faces
/// agree on their common border to the last bit.
glm::dvec3 direction_at(SphereMapping mapping, int face, glm::dvec2 st);
/// Returns the face of a unit direction, and s and t on it. The inverse of direction_at().
std::pair<int, glm::dvec2> face_place(SphereMapping mapping, const glm::dvec3& direction);

/// A patch: one of 2^level x 2^level on its face.
struct SpherePatch {
    int face = 0, level = 0, x = 0, y = 0;
    auto operator<=>(const SpherePatch&) const = default;

    /// Returns the place on the face, each coordinate in [-1, 1], of a place on the patch from (0, 0) to (1, 1).
    glm::dvec2 on_face(glm::dvec2 local) const {
        const double width = 2.0 / (1 << level);  // a power of 2: neighbours agree to the last bit
        return width * (glm::dvec2(x, y) + local) - 1.0;
    }
    /// Returns one of the four patches of the next level, 0 to 3.
    SpherePatch child(int i) const { return {face, level + 1, 2 * x + i % 2, 2 * y + i / 2}; }
};
/// Returns the patch of a level in which a place on a face lies.
SpherePatch patch_at(int face, glm::dvec2 st, int level);

}  // namespace relief
