// How coarse a relief may be for an error budget in pixels, in double precision. The twins of the functions in
// shaders/17_time_and_error/task.glsl. The twin of spread_shininess() is toksvig_factor().
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace relief {

/// The speed on the screen, in pixels per metre, of a point at `clip` that begins to move. `along` is its change in
/// clip space per metre. `size` is the picture's, in pixels.
double pixels_per_metre(const glm::dvec4& clip, const glm::dvec4& along, const glm::dvec2& size);

/// The largest error of a height in [0, 1] that shows as at most `budget` pixels on the screen. The relief is `scale`
/// metres deep. 1e30 for a relief without depth.
double tolerated(double budget, double pixels_per_metre, double scale);

/// The range (lowest, highest) of a relief after `max_cut` is taken off at both ends. If nothing is left, both are the
/// middle of the range.
glm::dvec2 thinned(double lowest, double highest, double max_cut);

/// The fractional mip level at which the error reaches `tolerance`. `errors[i]` is the error of level i; the errors
/// never fall, and between two levels the error is linear. 0 if even level 0 is above the tolerance, the last level if
/// all are below. `errors` is not empty.
double coarsest_level(std::span<const float> errors, double tolerance);

/// How much of the bumps is left, in [0, 1], for a pixel that reads mip level `level` with an error budget of `budget`
/// pixels. The map is flat from `flat_level` on. The bumps fade out over the last level before it; the budget makes the
/// pixel count as log2(budget) levels coarser.
double bumps_left(double level, double flat_level, double budget);

}  // namespace relief
