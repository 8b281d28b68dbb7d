// The axes of a camera's picture, for shaders that compute the ray of a pixel.
#pragma once

#include <cmath>
#include <glm/glm.hpp>

#include "framework/core/lab/lab.h"

namespace relief {

/// Unit vectors in the world, and half of the picture's height one metre ahead. The ray through a point of the picture,
/// x and y in [-1, 1], is along forward + half_height * (aspect * x * right + y * up).
struct ViewAxes {
    glm::dvec3 right, up, forward;
    double half_height;
};
inline ViewAxes view_axes(const Camera& camera) {
    const glm::dmat4 view = camera.view_from_world();
    const auto row = [&](int i) { return glm::dvec3(view[0][i], view[1][i], view[2][i]); };
    return {row(0), row(1), -row(2), std::tan(glm::radians(camera.orbit().field_of_view) / 2)};
}

/// Sets u_forward, u_right and u_up, of which the sum forward + x right + y up is the ray of a point, x and y in
/// [-1, 1]. Precondition: the program is in use.
inline void set_rays(const Program& program, const Frame& frame) {
    const ViewAxes axes = view_axes(frame.camera);
    program.set("u_forward", axes.forward);
    program.set("u_right", axes.right * (axes.half_height * frame.size.x / frame.size.y));
    program.set("u_up", axes.up * axes.half_height);
}

}  // namespace relief
