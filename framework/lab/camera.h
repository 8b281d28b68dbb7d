// The orbit camera, in double precision.
#pragma once

#include <glm/glm.hpp>

#include "framework/mesh/ray.h"

namespace relief {

/// Where the camera is: on a sphere around the target. Degrees and metres; yaw 0 looks along -z, yaw grows as
/// the camera moves to the right, pitch grows as it rises (-89 to 89).
struct Orbit {
    double yaw = 30, pitch = 20, distance = 3;
    glm::dvec3 target{0, 0, 0};
    double field_of_view = 40;  ///< vertical, degrees
    bool operator==(const Orbit&) const = default;
};

class Camera {
public:
    /// `aspect` is width over height.
    Camera(const Orbit& orbit, double aspect);

    const Orbit& orbit() const { return orbit_; }
    glm::dvec3 eye() const { return eye_; }
    glm::dmat4 view_from_world() const { return view_from_world_; }
    glm::dmat4 clip_from_view() const { return clip_from_view_; }
    glm::dmat4 clip_from_world() const { return clip_from_view_ * view_from_world_; }
    /// The same camera for a picture of another shape.
    Camera with_aspect(double aspect) const { return {orbit_, aspect}; }
    /// The ray through a point of the picture: x and y in [-1, 1], y up. Its direction is normalised.
    Ray ray(glm::dvec2 clip) const;

private:
    Orbit orbit_;
    glm::dvec3 eye_;
    glm::dmat4 view_from_world_, clip_from_view_;
};

}  // namespace relief
