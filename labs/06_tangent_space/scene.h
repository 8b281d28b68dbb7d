// The shapes of lab 06, and the depth of its bricks.
#pragma once

#include "framework/library/mesh/shapes.h"

namespace relief::frames {

/// The first ones are the choices of the knob `shape`, in its order. The cube is that of a view.
enum class Shape { sphere, column, wall, own, cube };

// A tile of bricks is as wide as it is high on the column and on the wall, and at the sphere's equator.
constexpr SphereShape sphere{.radius = 1, .sides = 48, .rows = 24, .repeat = {4, 2}};
constexpr ColumnShape column{
    .bottom_radius = 0.6f, .top_radius = 0.6f, .height = 1.884956f, .sides = 64, .rows = 1, .repeat = {2, 1}};
/// Its left half is the mirror image of the right one: u decreases towards the middle, then increases.
constexpr QuadShape wall{.width = 2, .height = 2, .repeat = {2, 2}};
constexpr BoxShape cube{.size = {1.3f, 1.3f, 1.3f}};
constexpr double bricks_depth_in_texels = 24;  // assets/SOURCES.md

/// Returns the wall: two quads, of which the left one has a left-handed frame.
inline Mesh make_mirrored_wall() {
    Mesh mesh;
    for (const float side : {-1.0f, 1.0f}) {
        const uint32_t begin = uint32_t(mesh.vertices.size());
        for (const float y : {-1.0f, 1.0f})
            for (const float x : {0.0f, 1.0f})
                mesh.vertices.push_back({{side * x, y, 0}, {0, 0, 1}, {side, 0, 0, side}, {x, (y + 1) / 2 * 2}});
        for (const uint32_t i : {0u, 1u, 3u, 0u, 3u, 2u}) mesh.indices.push_back(begin + i);
        if (side < 0)
            for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    }
    return mesh;
}

}  // namespace relief::frames
