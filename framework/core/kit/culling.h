// Objects that the picture does not show, by their bounding spheres.
#pragma once

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

}  // namespace relief
