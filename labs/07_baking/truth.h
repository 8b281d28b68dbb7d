// The exact values of lab 07's probes.
#pragma once

#include "baker.h"
#include "framework/base/from_staff.h"

namespace relief::baking {

/// What a tile of the picture shows.
enum class Shown { high, low, mapped, nothing };
struct Sight {
    Recipe recipe;
    Shown shown = Shown::mapped;
    bool other_diagonal = false;  ///< of the model on the screen
};

/// Of `normal`: what a bake without a map would show at each pixel: from the place on the coarse model that the pixel
/// sees, by the ray of a perfect bake, to the fine one. Of the cube the normal of its face. Where nothing is met, the
/// coarse model's own normal. Of the high model its own.
inline FromStaff<std::optional<Image>(const Frame& frame, const Sight& sight)> normal_truth;
/// Of `stored`, `hit` and `cover`, over a picture of the whole map: in its frame the normal at each texel of the
/// recipe's map; metres above the coarse model; how many triangles cover the pixel.
inline FromStaff<std::optional<Image>(const Frame& frame, const Probe& probe, const Recipe& recipe)> map_truth;

}  // namespace relief::baking
