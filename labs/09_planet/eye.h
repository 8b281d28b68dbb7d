// An eye at any place that looks anywhere, for labs whose camera does not only orbit.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "framework/core/base/ray.h"
#include "framework/core/lab/lab.h"

namespace relief {

struct Eye {
    glm::dvec3 place{0, 0, 3};
    glm::dmat3 view_from_world{1};  ///< a rotation
    double field_of_view_rad = 0.7, aspect = 1;

    static Eye of(const Camera& camera, double aspect) {
        return {camera.eye(), glm::dmat3(camera.view_from_world()), glm::radians(camera.orbit().field_of_view), aspect};
    }
    /// Returns an eye at `place` that looks along the unit vector `along`, with `up` upwards in the picture.
    static Eye looking(const glm::dvec3& place, const glm::dvec3& along, const glm::dvec3& up, double field_of_view_rad,
                       double aspect) {
        const glm::dvec3 right = glm::normalize(glm::cross(along, up)), above = glm::cross(right, along);
        return {place, glm::transpose(glm::dmat3(right, above, -along)), field_of_view_rad, aspect};
    }

    /// Returns the tangent of half the field of view.
    double tangent() const { return std::tan(field_of_view_rad / 2); }
    /// Returns the ray of unit direction through a place of the picture, with x and y in [-1, 1].
    Ray ray(glm::dvec2 clip) const {
        const glm::dvec3 seen(clip.x * tangent() * aspect, clip.y * tangent(), -1);
        return {place, glm::normalize(glm::transpose(view_from_world) * seen)};
    }
    /// Returns whether a sphere is wholly outside of the picture or behind the eye. Conservative: may return false.
    bool misses(const glm::dvec3& middle, double radius) const {
        const glm::dvec3 seen = view_from_world * (middle - place);
        const double y = tangent(), x = y * aspect;
        // Signed distances to the side planes of the view frustum, positive inside.
        const double sideways = (-seen.z * x - std::abs(seen.x)) / std::sqrt(1 + x * x);
        const double upwards = (-seen.z * y - std::abs(seen.y)) / std::sqrt(1 + y * y);
        return seen.z > radius || sideways < -radius || upwards < -radius;
    }
};

}  // namespace relief
