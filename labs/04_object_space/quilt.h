// The quilted column of lab 04: its base, its relief, and how it stands at rest.
#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "framework/mesh/shapes.h"

namespace relief::quilt {

constexpr ColumnShape column{.bottom_radius = 0.42f, .top_radius = 0.42f, .height = 1.7f, .sides = 64, .rows = 24};
/// Height 1 lies so many metres above height 0, along the column's normal.
constexpr double scale = 0.06;

/// Diamonds: h = 1/2 + (cos 2 pi (8 u + 5 v) + cos 2 pi (8 u - 5 v)) / 4, u around and v up, in [0, 1].
inline double height(glm::dvec2 uv) {
    const double turn = 2 * glm::pi<double>();
    return 0.5 + 0.25 * (std::cos(turn * (8 * uv.x + 5 * uv.y)) + std::cos(turn * (8 * uv.x - 5 * uv.y)));
}
inline glm::dvec2 slope(glm::dvec2 uv) {
    const double turn = 2 * glm::pi<double>();
    const double one = std::sin(turn * (8 * uv.x + 5 * uv.y)), two = std::sin(turn * (8 * uv.x - 5 * uv.y));
    return -0.25 * turn * glm::dvec2(8 * (one + two), 5 * (one - two));
}

/// How the column stands in the world when nothing moves it.
inline glm::dmat4 rest() {
    return glm::rotate(glm::rotate(glm::dmat4(1), glm::radians(-8.0), {0, 0, 1}), glm::radians(50.0), {0, 1, 0});
}

}  // namespace relief::quilt
