// Objects that the picture does not show, by their bounding spheres or corners.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>

namespace relief {

/// Returns whether a sphere may be visible between two places of the picture from left to right. `columns` are their x
/// in clip space, from -1 to 1. Conservative: may return true for a sphere near a corner.
inline bool may_be_seen(const glm::dmat4& clip_from_world, const glm::dvec3& centre, double radius,
                        glm::dvec2 columns = {-1, 1}) {
    const glm::dmat4 rows = glm::transpose(clip_from_world);
    const auto reaches = [&](const glm::dvec4& plane) {
        return !(glm::dot(plane, glm::dvec4(centre, 1)) < -radius * glm::length(glm::dvec3(plane)));
    };
    return reaches(rows[0] - columns[0] * rows[3]) && reaches(columns[1] * rows[3] - rows[0]) &&
           reaches(rows[3] + rows[1]) && reaches(rows[3] - rows[1]) && reaches(rows[3] + rows[2]) &&
           reaches(rows[3] - rows[2]);
}

/// Returns whether the convex hull of some corners is outside of the picture: beyond one of its four sides, or behind
/// the eye. Conservative: may return false for a hull near a corner of the picture.
template <class Corners>
bool is_outside(const glm::dmat4& clip_from_world, const Corners& corners) {
    std::array<bool, 5> all;
    all.fill(true);
    for (const glm::dvec3& corner : corners) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(corner, 1);
        const std::array outside = {clip.x<-clip.w, clip.x> clip.w, clip.y<-clip.w, clip.y> clip.w, clip.w < 0};
        for (size_t side = 0; side < all.size(); ++side) all[side] = all[side] && outside[side];
    }
    return std::find(all.begin(), all.end(), true) != all.end();
}

}  // namespace relief
