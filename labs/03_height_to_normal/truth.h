// The exact values of lab 03's probes, and the lab's maps made by the CPU.
#pragma once

#include "framework/core/base/from_staff.h"
#include "framework/core/lab/lab.h"
#include "framework/library/maps/line_slopes.h"

namespace relief::heights {

/// Returns the unit normals of the known function at the centres of size x size texels: 3 channels in [-1, 1]. `texels`
/// is a height of 1, in texels along u and along v.
Image exact_normals(int size, glm::dvec2 texels);

/// Returns the framework's normals of the heights: 3 channels in [-1, 1].
inline FromStaff<Image(const Image& heights, const NormalOptions& options)> normals_by_cpu;

/// Returns the framework's heights of a colour picture in sRGB.
inline FromStaff<Image(const Image& picture)> heights_by_cpu;

/// Returns the ambient occlusion of each texel by the horizons around it: 1 if the whole sky is visible. `texels` is a
/// height of 1, in texels.
inline FromStaff<Image(const Image& heights, double texels)> open_to_the_sky;

/// Returns the place on the map at which a ray meets a wall, in [0, 1); see on_wall(). Nothing beside the wall.
std::optional<glm::dvec2> place_on_wall(const Ray& ray, glm::dvec2 wall, double repeat);

/// Returns the frame of a wall that shows `map` (row 0 at the top), `repeat` times along each side. `wall` is half the
/// size of the wall in metres. Each pixel has the value of the texel at its centre, or +infinity beside the wall.
Image on_wall(const Frame& frame, const Image& map, glm::dvec2 wall, double repeat);

}  // namespace relief::heights
