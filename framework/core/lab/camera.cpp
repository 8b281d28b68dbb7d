#include "framework/core/lab/camera.h"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace relief {

Camera::Camera(const Orbit& orbit, double aspect) : orbit_(orbit) {
    orbit_.pitch = std::clamp(orbit_.pitch, -89.0, 89.0);  // at 90 "up" would be degenerate
    const double yaw_rad = glm::radians(orbit_.yaw), pitch_rad = glm::radians(orbit_.pitch);
    const glm::dvec3 out(std::sin(yaw_rad) * std::cos(pitch_rad), std::sin(pitch_rad),
                         std::cos(yaw_rad) * std::cos(pitch_rad));
    eye_ = orbit_.target + orbit_.distance * out;
    view_from_world_ = glm::lookAt(eye_, orbit_.target, glm::dvec3(0, 1, 0));
    // Near and far planes are proportional to the distance, so a scene can have any size.
    clip_from_view_ =
        glm::perspective(glm::radians(orbit_.field_of_view), aspect, orbit_.distance * 0.02, orbit_.distance * 50);
}

Ray Camera::ray(glm::dvec2 clip) const {
    const glm::dmat4 world_from_clip = glm::inverse(clip_from_world());
    const glm::dvec4 far = world_from_clip * glm::dvec4(clip, 1, 1);
    return {eye_, glm::normalize(glm::dvec3(far) / far.w - eye_)};
}

}  // namespace relief
