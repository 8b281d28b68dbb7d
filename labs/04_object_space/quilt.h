// The quilted column of lab 04: its base, its relief, and its orientation at rest.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "framework/library/mesh/shapes.h"

namespace relief::quilt {

constexpr ColumnShape column{.bottom_radius = 0.42f, .top_radius = 0.42f, .height = 1.7f, .sides = 64, .rows = 24};
/// Depth of the relief: metres from height 0 to height 1, along the column's normal.
constexpr double scale = 0.06;

/// Returns the height of diamonds, h = 1/2 + (cos 2 pi (8 u + 5 v) + cos 2 pi (8 u - 5 v)) / 4, in [0, 1]. u goes
/// around the column, and v up.
inline double height(glm::dvec2 uv) {
    const double turn = 2 * glm::pi<double>();
    return 0.5 + 0.25 * (std::cos(turn * (8 * uv.x + 5 * uv.y)) + std::cos(turn * (8 * uv.x - 5 * uv.y)));
}
/// Returns dh/du and dh/dv.
inline glm::dvec2 slope(glm::dvec2 uv) {
    const double turn = 2 * glm::pi<double>();
    const double one = std::sin(turn * (8 * uv.x + 5 * uv.y)), two = std::sin(turn * (8 * uv.x - 5 * uv.y));
    return -0.25 * turn * glm::dvec2(8 * (one + two), 5 * (one - two));
}

/// Returns world_from_model of the column at rest.
inline glm::dmat4 rest() {
    return glm::rotate(glm::rotate(glm::dmat4(1), glm::radians(-8.0), {0, 0, 1}), glm::radians(50.0), {0, 1, 0});
}

}  // namespace relief::quilt
