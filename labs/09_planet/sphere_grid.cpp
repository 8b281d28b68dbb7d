#include "sphere_grid.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/library/mesh/shapes.h"

namespace relief {
namespace {

/// Returns cosine and sine of quarter turns. Whole numbers of them are exact, so that both halves meet.
glm::dvec2 turned(double quarters) {
    const double whole = std::round(quarters), rest = glm::half_pi<double>() * (quarters - whole);
    const double c = std::cos(rest), s = std::sin(rest);
    switch (int(whole) & 3) {
        case 0:
            return {c, s};
        case 1:
            return {-s, c};
        case 2:
            return {-c, -s};
        default:
            return {s, -c};
    }
}

}  // namespace

glm::dmat3 face_axes(SphereMapping mapping, int face) {
    if (mapping == SphereMapping::lat_long) return glm::dmat3({face ? -1 : 1, 0, 0}, {0, 1, 0}, {0, 0, face ? -1 : 1});
    const CubeFace& axes = cube_face(face);
    return {axes.right, axes.up, axes.normal};
}

glm::dvec3 direction_at(SphereMapping mapping, int face, glm::dvec2 st) {
    if (mapping == SphereMapping::lat_long) {
        const glm::dvec2 around = turned(st.x + 2 * face), up = turned(st.y);
        return {up.x * around.y, up.y, up.x * around.x};
    }
    if (mapping == SphereMapping::gnomonic)
        for (int i = 0; i < 2; ++i)
            if (std::abs(st[i]) != 1) st[i] = std::atan(st[i]) / glm::quarter_pi<double>();
    return cube_sphere_direction(face, st.x, st.y);
}

std::pair<int, glm::dvec2> face_place(SphereMapping mapping, const glm::dvec3& direction) {
    if (mapping == SphereMapping::lat_long) {
        const int face = direction.z < 0;
        const double side = face ? -1 : 1;
        return {face, glm::dvec2(std::atan2(side * direction.x, side * direction.z), std::asin(direction.y)) /
                          glm::half_pi<double>()};
    }
    const glm::dvec3 size = glm::abs(direction);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int face = 2 * axis + (direction[axis] < 0);
    const glm::dvec3 on_face = glm::transpose(face_axes(mapping, face)) * direction;
    const glm::dvec2 on_cube = glm::dvec2(on_face) / on_face.z;
    return {face, mapping == SphereMapping::gnomonic ? on_cube : glm::atan(on_cube) / glm::quarter_pi<double>()};
}

SpherePatch patch_at(int face, glm::dvec2 st, int level) {
    const glm::ivec2 at(glm::clamp((st + 1.0) / 2.0, 0.0, 1 - 1e-12) * double(1 << level));
    return {face, level, at.x, at.y};
}

}  // namespace relief
