// The colonnade of lab 01: its shapes and their places, for the picture and for the exact values.
#pragma once

#include <array>
#include <glm/glm.hpp>

#include "framework/library/mesh/shapes.h"

namespace relief::colonnade {

constexpr QuadShape ground{.width = 60, .height = 60, .repeat = {24, 24}};  // turned to face up
// The taper is straight, but needs rows: uv would bend on the two triangles of one long trapezoid.
constexpr ColumnShape column{.bottom_radius = 0.5f, .top_radius = 0.34f, .height = 2.6f, .rows = 6, .repeat = {2, 2}};
constexpr SphereShape ball{.radius = 0.42f, .sides = 32, .rows = 16, .repeat = {2, 1}};
/// The feet of the columns, and the offset of the balls above them.
constexpr std::array<glm::vec3, 6> places = {
    {{-1.4f, 0, 1.2f}, {1.4f, 0, 1.2f}, {-1.4f, 0, -1.6f}, {1.4f, 0, -1.6f}, {-1.4f, 0, -4.4f}, {1.4f, 0, -4.4f}}};
constexpr glm::vec3 top{0, 2.95f, 0};
/// The middle of a column above its foot, and the radius of its bounding sphere.
constexpr glm::vec3 middle{0, column.height / 2, 0};
constexpr float column_reach = 1.4f;
static_assert(column_reach * column_reach > middle.y * middle.y + column.bottom_radius * column.bottom_radius);

}  // namespace relief::colonnade
