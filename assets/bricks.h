// A wall of old bricks in running bond: 4 bricks by 8 courses per tile.
#pragma once

#include "assets/surface.h"

namespace relief {

/// The size of the course's own maps, in texels per side.
constexpr int bricks_size = 1024;
/// Height 1 in texels of a map of that size; proportional for other sizes.
constexpr double bricks_depth_in_texels = 24;

/// Returns maps of `size` by `size` texels. Height 1 is the highest brick's face. The mortar lies about 18 texels (of
/// 1024) below the average face. Slopes reach about 1.7 on the bricks' edges and are gentle on their faces.
SurfaceMaps make_bricks(int size = bricks_size);

}  // namespace relief
