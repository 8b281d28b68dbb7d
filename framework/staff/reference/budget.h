// The coarsest relief that stays within an error budget in pixels, in double precision. Twins of the functions in
// shaders/17_time_and_error/task.glsl. The twin of spread_shininess() is toksvig_factor().
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace relief {

/// Returns the screen speed, in pixels per metre, of a moving point at `clip`. `along` is the derivative of its
/// clip-space position per metre. `size` is the picture's, in pixels.
double pixels_per_metre(const glm::dvec4& clip, const glm::dvec4& along, const glm::dvec2& size);

/// Returns the largest error of a height in [0, 1] that shows as at most `budget` pixels on the screen. The relief is
/// `scale` metres deep. Returns 1e30 for a relief without depth.
double tolerated(double budget, double pixels_per_metre, double scale);

/// Returns the range (lowest, highest) of a relief after `max_cut` is removed at both ends. If nothing is left, both
/// are the middle of the range.
glm::dvec2 thinned(double lowest, double highest, double max_cut);

/// Returns the fractional mip level at which the error reaches `tolerance`. `errors[i]` is the error of level i: not
/// empty, non-decreasing, and linear between two levels. Returns 0 if even level 0 is above the tolerance, and the last
/// level if all are below.
double coarsest_level(std::span<const float> errors, double tolerance);

/// Returns the remaining share of the bumps, in [0, 1], for a pixel that reads mip level `level` with an error budget
/// of `budget` pixels. The map is flat from `flat_level` on. The bumps fade out over the last level before it. The
/// budget raises the pixel's level by log2(budget).
double bumps_left(double level, double flat_level, double budget);

}  // namespace relief
