// What lab 19 shows: the two layers on a wall, and the solids.
#pragma once

#include <array>

#include "framework/core/base/mesh.h"
#include "settings.h"

namespace relief::layered_normals {

constexpr double stone_tile = 2;  ///< side of the stones' tile, metres
constexpr double lump = 0.055;    ///< amplitude of a rock's waves

/// The waves of a rock, which is |p|² + sum lump sin(k p + phase) = 1: k, and phase in radians.
constexpr std::array<glm::dvec4, 8> lumps = {{{2.1, 0.4, -0.9, 0.3},
                                              {-0.7, 2.4, 1.1, 1.9},
                                              {1.2, -1.0, 2.2, 4.0},
                                              {3.1, 1.9, 0.6, 2.4},
                                              {-2.2, 0.8, 3.4, 5.1},
                                              {0.9, -3.6, 1.7, 0.8},
                                              {4.4, 2.2, -2.9, 3.3},
                                              {-3.2, 4.1, 2.6, 1.2}}};

/// The smooth surface of a solid at a place: unit normal, and the gradients of its x, y and z as columns.
struct Surface {
    glm::dvec3 normal;
    glm::dmat3 turns;
};
/// Returns that of a sphere or a rock. `place` need not be on it: then it is that of the level set through the place.
Surface surface_at(const glm::dvec3& place, bool is_rock);

/// Returns the triangles of a solid, Settings::Shape.
Mesh solid_mesh(int shape);

}  // namespace relief::layered_normals
