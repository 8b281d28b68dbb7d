// The exact values of lab 03's probes, and the same maps made by the CPU.
#pragma once

#include "framework/base/from_staff.h"
#include "framework/height/lines.h"
#include "framework/lab/lab.h"

namespace relief::heights {

/// The unit normals of the known function at the centres of size x size texels, not packed: 3 channels in [-1, 1].
/// `texels` is what height 1 is worth along u and v.
Image exact_normals(int size, glm::dvec2 texels);

/// What the framework makes of the same heights, not packed.
inline FromStaff<Image(const Image& heights, const NormalOptions& options)> normals_by_cpu;

/// What the framework makes of a colour picture.
inline FromStaff<Image(const Image& picture)> heights_by_cpu;

/// How open each texel is to the sky, 1 being wide open, by the horizons around it. `texels`: of a height of 1.
inline FromStaff<Image(const Image& heights, double texels)> open_to_the_sky;

/// `map` (row 0 at the top) as a wall of half the size `wall` shows it that many times along each side: the texel at
/// the centre of each pixel, +infinity beside the wall.
Image on_wall(const Frame& frame, const Image& map, glm::dvec2 wall, double repeat);

}  // namespace relief::heights
