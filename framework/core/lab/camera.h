// The orbit camera, in double precision.
#pragma once

#include <glm/glm.hpp>

#include "framework/core/base/ray.h"

namespace relief {

/// The camera's position on a sphere around the target. Degrees and metres. Yaw 0 looks along -z. Yaw grows as the
/// camera moves to the right, and pitch as it rises, from -89 to 89.
struct Orbit {
    double yaw = 30, pitch = 20, distance = 3;
    glm::dvec3 target{0, 0, 0};
    double field_of_view = 40;  ///< vertical, degrees
    bool operator==(const Orbit&) const = default;
};

class Camera {
public:
    /// `aspect` is width divided by height. Clamps the pitch to -89..89.
    Camera(const Orbit& orbit, double aspect);

    const Orbit& orbit() const { return orbit_; }
    glm::dvec3 eye() const { return eye_; }
    glm::dmat4 view_from_world() const { return view_from_world_; }
    glm::dmat4 clip_from_view() const { return clip_from_view_; }
    glm::dmat4 clip_from_world() const { return clip_from_view_ * view_from_world_; }
    /// Returns the ray through a point of the picture, x and y in [-1, 1], y up. Its direction is normalised.
    Ray ray(glm::dvec2 clip) const;

private:
    Orbit orbit_;
    glm::dvec3 eye_;
    glm::dmat4 view_from_world_, clip_from_view_;
};

}  // namespace relief
