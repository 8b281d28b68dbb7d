// The exact values of lab 07's probes.
#pragma once

#include "baker.h"
#include "framework/core/base/from_staff.h"

namespace relief::baking {

/// The content of a tile of the picture.
enum class Shown { high, low, mapped, nothing };
struct Sight {
    Recipe recipe;
    Shown shown = Shown::mapped;
    bool other_diagonal = false;  ///< the model on the screen has the other diagonals than the bake
};

/// Returns the exact normals of the probe `normal`, as of a bake of infinite resolution. From the place on the
/// coarse model at a pixel a ray finds the fine one, whose normal is the result. If the ray hits nothing, it is the
/// coarse model's normal. The cube has the normals of its faces, and the high model has its own.
inline FromStaff<std::optional<Image>(const Frame& frame, const Sight& sight)> normal_truth;
/// Returns the exact values of the map's probes, over a picture of the whole map:
///  - `stored`: the normal of each texel of the recipe's map, in its frame
///  - `hit`: height of the hit above the coarse model, metres
///  - `cover`: number of triangles that cover the pixel
/// Returns nothing for `stored` and `hit` if islands overlap.
inline FromStaff<std::optional<Image>(const Frame& frame, const Recipe& recipe)> map_truth;

}  // namespace relief::baking
