// A ring of rope: a coarse model with the normal map of a fine one, as glTF 2.0.
#pragma once

#include "framework/core/base/mesh.h"
#include "framework/core/image/image.h"

namespace relief {

/// Returns the torus that wears the map, with the tangents of MikkTSpace. uv is in [0, 1].
Mesh make_coarse_rope();
/// Returns three strands that are twisted around each other, with their fibres.
Mesh make_fine_rope();
/// Bakes the fine rope's normals for the coarse one, in tangent space: 3 x 8 bits.
Image bake_rope();

}  // namespace relief
