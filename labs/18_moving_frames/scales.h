// The scales of a fish or a snake, as a normal map that tiles.
#pragma once

#include "framework/core/image/image.h"

namespace relief {

/// Returns a tile of texels x texels, at least 1, with two scales from side to side and four rows. Tips point down. The
/// first three channels are normals (green up), the fourth heights, with 8 bits.
Image make_scales(int texels);

}  // namespace relief
