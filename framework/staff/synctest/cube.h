// The cube that must stay flat: twelve triangles with averaged normals, the map of a flat cube, and what renderers with
// other frames make of the two. It shows whether a renderer reads a normal map in the frame in which it was baked.
#pragma once

#include <string>
#include <vector>

#include "framework/image/image.h"
#include "framework/lab/camera.h"
#include "framework/mesh/mesh.h"

namespace relief {

/// Of side 1, around the origin: four vertices a face, whose normals are those of the corner, averaged over its three
/// faces; tangents by MikkTSpace; each face a square of the map. Quads are cut from the lower left to the upper right
/// corner, or the other way.
Mesh make_synctest_cube(bool other_diagonal = false);

/// The normals of the flat cube in the interpolated frame of that mesh (MikkTSpace's rule), linear and green-up. Each
/// face goes on beyond its square. `bits` 8, 16 or 32.
Image bake_synctest_map(int size, int bits);

/// How a renderer makes its frame of the interpolated normal and tangent.
enum class SyncFrame { interpolated, each_unit, gram_schmidt, vertex_bitangent };
/// What else it does with mesh and map.
enum class SyncSlip { none, other_diagonal, green_turned, srgb_map, no_map };

struct SyncRenderer {
    SyncFrame frame = SyncFrame::interpolated;
    SyncSlip slip = SyncSlip::none;
    bool operator==(const SyncRenderer&) const = default;

    bool is_in_sync() const { return *this == SyncRenderer{}; }
    /// "Gram-Schmidt at each pixel", "as interpolated, green turned around"
    std::string text() const;
};
/// All that differ.
std::vector<SyncRenderer> sync_renderers();

/// From which the picture is to be taken: three faces are seen.
constexpr Orbit synctest_camera{.yaw = 30, .pitch = 25, .distance = 4, .target = {0, 0, 0}, .field_of_view = 20};

/// Normals in the cube's space, as that renderer shows them, no_surface beside the cube. The map is read at level 0,
/// with linear filtering. Of each `step` x `step` pixels of the picture only the first is computed.
Image render_synctest(const SyncRenderer& renderer, const Image& map, int width, int height, int step = 1);

}  // namespace relief
