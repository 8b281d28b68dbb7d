// How finely an edge of a patch is to be cut, in double precision. The twin of shaders/common/tessellation.glsl.
#pragma once

#include <glm/glm.hpp>

namespace relief {

/// What GL 4 can do.
constexpr double max_tessellation_level = 64;

/// The level within 1 to 64; one that is not a number becomes 1.
double possible_level(double level);

/// 2^finest at `nearest` or nearer, 2^coarsest at `farthest` or farther, the exponent linear between (Luna 2012).
/// Distances in metres, nearest < farthest.
double level_by_distance(double distance, double nearest, double farthest, double finest, double coarsest);

/// The edge's length as the diameter of a sphere around its middle, in pixels of the screen, over the pixels that one
/// segment may have; from 1 to 64. It does not fall when the edge turns towards the eye. `pixels_per_radian` is the
/// picture's height in pixels over 2 tan(field of view / 2).
double level_by_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double pixels_per_radian,
                     double pixels_per_segment);

/// Chords of length s leave a curve h by up to s² |h''| / 8. For at most `budget` pixels an edge of `length` metres at
/// `distance` metres needs so many segments, from 1 to 64; `curvature` is the largest |h''| along it, in 1/metre.
double level_by_error(double length, double curvature, double distance, double pixels_per_radian, double budget);

}  // namespace relief
