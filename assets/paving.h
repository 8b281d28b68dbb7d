// A floor of riven grey flagstones: four rows of four, no two alike.
#pragma once

#include "assets/surface.h"

namespace relief {

/// The size of the course's own maps.
constexpr int paving_size = 1024;
/// What height 1 is worth in texels of a map of that size; in proportion at any other.
constexpr double paving_depth_in_texels = 12;

/// `size` by `size` texels. Height 1 is just above the highest stone; the joints lie about 7.5 texels (of
/// 1024) below the average face.
SurfaceMaps make_paving(int size = paving_size);

}  // namespace relief
