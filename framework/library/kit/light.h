// The lights of labs: a direction with its knobs, and a lamp around the vertical axis.
#pragma once

#include <cmath>

#include "framework/core/lab/lab.h"
#include "framework/library/mesh/parallelogram.h"

namespace relief {

/// A distant light, in degrees. At yaw 0 and pitch 0 it shines from the positive end of the z axis; yaw grows to the
/// right.
struct DistantLight {
    float yaw = -50, pitch = 40;

    void knobs(Knobs& knobs, float min_pitch = -90, float max_pitch = 90) {
        knobs.group("Light");
        knobs.slider("light_yaw", yaw, -180, 180, KnobHelp("direction of the light").in("degrees"));
        knobs.slider("light_pitch", pitch, min_pitch, max_pitch, KnobHelp("elevation of the light").in("degrees"));
    }
    /// Returns the unit vector towards the light.
    template <class Number = float>
    glm::vec<3, Number> direction() const {
        const Number yaw_rad = glm::radians(Number(yaw)), pitch_rad = glm::radians(Number(pitch));
        return {std::sin(yaw_rad) * std::cos(pitch_rad), std::sin(pitch_rad), std::cos(yaw_rad) * std::cos(pitch_rad)};
    }
};

/// The view of a distant light, which looks along -z of its own space: for a depth map.
struct LightView {
    glm::dmat3 light_from_world;
    glm::dmat4 clip_from_world;
    double width, depth;  ///< of the box that the clip space is: its width and height, and along the light; metres
};
/// Returns the view of everything between two corners of an axis-aligned box, with a margin. `to_light` has unit length
/// and any direction, straight up included.
inline LightView light_view(const glm::dvec3& to_light, const glm::dvec3& low, const glm::dvec3& high) {
    const PlaneAxes axes = plane_axes(to_light);
    const glm::dmat3 light_from_world = glm::transpose(glm::dmat3(axes.right, axes.up, to_light));
    glm::dvec3 least(INFINITY), most(-INFINITY);
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 corner(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
        least = glm::min(least, light_from_world * corner), most = glm::max(most, light_from_world * corner);
    }
    const double width = std::max(most.x - least.x, most.y - least.y) * 1.01, depth = (most.z - least.z) * 1.01 + 1e-3;
    const glm::dvec3 middle = (least + most) / 2.0;
    const glm::dmat4 clip_from_light(2 / width, 0, 0, 0, 0, 2 / width, 0, 0, 0, 0, -2 / depth, 0, -2 * middle.x / width,
                                     -2 * middle.y / width, 2 * middle.z / depth, 1);
    return {light_from_world, clip_from_light * glm::dmat4(light_from_world), width, depth};
}

/// Returns the position of a lamp around the vertical axis. At yaw 0 (degrees) it is on the side of +z.
inline glm::vec3 lamp_at(float yaw, float distance, float height) {
    const float yaw_rad = glm::radians(yaw);
    return {distance * std::sin(yaw_rad), height, distance * std::cos(yaw_rad)};
}

}  // namespace relief
