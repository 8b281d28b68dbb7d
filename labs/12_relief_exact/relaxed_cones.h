// Relaxed cones: a map for skipping that is popular and not safe.
#pragma once

#include "framework/core/image/image.h"

namespace relief::exact {

/// Returns for each texel the widest relaxed cone above it, in texels of radius per unit of height: inside it, a ray
/// that starts straight above the texel at height 1 leaves the surface at most at the cone's wall (Policarpo and
/// Oliveira 2007). So the cone may cut through whatever faces that start. It is not safe: a ray that starts lower, or
/// beside the texel, may enter the surface, leave it and enter it again within the cone.
///
/// The relief is looked at along 32 directions, a texel at a time, up to `relaxed_reach`; the cone's radius at height 1
/// is at most that. Precondition: one channel, sides that are powers of two; the map repeats.
Image relaxed_cone_map(const Image& heights, unsigned threads = 0);
constexpr int relaxed_reach = 64;

}  // namespace relief::exact
