// The lights of labs: a direction with its knobs, and a lamp around the vertical axis.
#pragma once

#include <cmath>

#include "framework/core/lab/lab.h"

namespace relief {

/// A distant light, in degrees. At yaw 0 and pitch 0 it shines from the positive end of the z axis; yaw grows to the
/// right.
struct DistantLight {
    float yaw = -50, pitch = 40;

    void knobs(Knobs& knobs, float min_pitch = -90, float max_pitch = 90) {
        knobs.group("Light");
        knobs.slider("light_yaw", yaw, -180, 180, "direction of the light, degrees");
        knobs.slider("light_pitch", pitch, min_pitch, max_pitch, "elevation of the light, degrees");
    }
    /// Returns the unit vector towards the light.
    template <class Number = float>
    glm::vec<3, Number> direction() const {
        const Number yaw_rad = glm::radians(Number(yaw)), pitch_rad = glm::radians(Number(pitch));
        return {std::sin(yaw_rad) * std::cos(pitch_rad), std::sin(pitch_rad), std::cos(yaw_rad) * std::cos(pitch_rad)};
    }
};

/// Returns the position of a lamp around the vertical axis. At yaw 0 (degrees) it is on the side of +z.
inline glm::vec3 lamp_at(float yaw, float distance, float height) {
    const float yaw_rad = glm::radians(yaw);
    return {distance * std::sin(yaw_rad), height, distance * std::cos(yaw_rad)};
}

}  // namespace relief
