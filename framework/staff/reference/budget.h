// What an error in pixels allows a relief, in double precision. Twins of the functions in
// shaders/17_time_and_error/task.glsl; that of spread_shininess() is toksvig_factor().
#pragma once

#include <glm/glm.hpp>
#include <span>

namespace relief {

/// How fast a pixel runs on a picture of `size` pixels when the place at `clip` begins to move, by `along` in clip
/// space for each metre.
double pixels_per_metre(const glm::dvec4& clip, const glm::dvec4& along, const glm::dvec2& size);

/// By how much a height in [0, 1] may be off if the error on the screen may be `budget` pixels and the relief is
/// `scale` metres deep; 1e30 for a relief without depth.
double tolerated(double budget, double pixels_per_metre, double scale);

/// The lowest and the highest height of a relief that is cut off below and above by `most`; the middle for both when
/// nothing is left.
glm::dvec2 thinned(double lowest, double highest, double max_cut);

/// The level, in parts, at which the polygon through errors that never fall reaches `tolerance`; 0 where it begins
/// above it, the last where it ends below. There is an error at least.
double coarsest_level(std::span<const float> errors, double tolerance);

/// The rest of bumps that a pixel reads from `level` if from `flat_level` on there are none, and `budget` pixels
/// may be off: from 1 a level before that to 0.
double bumps_left(double level, double flat_level, double budget);

}  // namespace relief
