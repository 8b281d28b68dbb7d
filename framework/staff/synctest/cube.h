// The cube that must stay flat: twelve triangles with averaged normals, the normal map of a flat cube, and renderings
// with other frames. It shows whether a renderer reads a normal map in the frame in which it was baked.
#pragma once

#include <string>
#include <vector>

#include "framework/core/base/mesh.h"
#include "framework/core/image/image.h"
#include "framework/core/lab/camera.h"

namespace relief::synctest {

/// Returns a cube with side 1 around the origin. Each face has four vertices and a square of the map. The normals are
/// the corner's normals, averaged over its three faces; tangents are by MikkTSpace. Quads are split from the lower left
/// to the upper right corner, or along the other diagonal.
Mesh make_synctest_cube(bool other_diagonal = false);

/// Returns the normals of the flat cube in the interpolated frame of that mesh (MikkTSpace's rule), linear and
/// green-up. Each face extends beyond its square. `bits` is 8, 16 or 32.
Image bake_synctest_map(int size, int bits);

/// How a renderer makes its frame from the interpolated normal and tangent.
enum class SyncFrame { interpolated, each_unit, gram_schmidt, vertex_bitangent };
/// Other mistakes of a renderer with mesh and map.
enum class SyncSlip { none, other_diagonal, green_turned, srgb_map, no_map };

struct SyncRenderer {
    SyncFrame frame = SyncFrame::interpolated;
    SyncSlip slip = SyncSlip::none;
    bool operator==(const SyncRenderer&) const = default;

    bool is_in_sync() const { return *this == SyncRenderer{}; }
    /// Returns a description such as "Gram-Schmidt at each pixel" or "as interpolated, green turned around".
    std::string text() const;
};
/// Returns all renderers that can be distinguished.
std::vector<SyncRenderer> sync_renderers();

/// The camera for the picture: three faces are visible.
constexpr Orbit synctest_camera{.yaw = 30, .pitch = 25, .distance = 4, .target = {0, 0, 0}, .field_of_view = 20};

/// Returns normals in the cube's space, as that renderer shows them; no_surface beside the cube. Samples the map at
/// level 0 with linear filtering. Computes only the first pixel of each `step` x `step` block.
Image render_synctest(const SyncRenderer& renderer, const Image& map, int width, int height, int step = 1);

}  // namespace relief::synctest
