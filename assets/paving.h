// A floor of riven grey flagstones: four rows of four different stones.
#pragma once

#include "assets/surface.h"

namespace relief {

/// The size of the course's own maps, in texels per side.
constexpr int paving_size = 1024;
/// Height 1 in texels of a map of that size; proportional for other sizes.
constexpr double paving_depth_in_texels = 12;

/// Returns maps of `size` by `size` texels. Height 1 is just above the highest stone. The joints lie about 7.5 texels
/// (of 1024) below the average face.
SurfaceMaps make_paving(int size = paving_size);

}  // namespace relief
