// Tessellation levels of a patch's edges, and culling of patches, in double precision. Twins of the functions in
// shaders/14_adaptive_displacement/task.glsl.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

namespace relief {

/// The maximum level that OpenGL 4 guarantees.
constexpr double max_tessellation_level = 64;

/// Returns the level, clamped to [1, 64]. NaN becomes 1.
double possible_level(double level);

/// Returns the level of the edge from `a` to `b` by the distance of its middle from the eye (Luna 2012). It is 2^finest
/// up to `nearest` metres and 2^coarsest from `farthest` metres on; the exponent is linear between. Precondition:
/// nearest < farthest.
double level_by_distance(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double nearest,
                         double farthest, double finest, double coarsest);

/// Returns the level, in [1, 64], at which segments of the edge are `pixels_per_segment` long on the screen. The edge
/// is measured as the diameter of a sphere around its middle, so the level does not fall when the edge turns towards
/// the eye. `pixels_per_radian` is the picture's height in pixels, divided by 2 tan(field of view / 2).
double level_by_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double pixels_per_radian,
                     double pixels_per_segment);

/// Returns the largest error of a height in [0, 1], `distance` metres away, that shows as at most `budget` pixels. The
/// relief is `scale` metres deep. Returns 1e30 for a relief without depth.
double tolerated(double distance, double pixels_per_radian, double budget, double scale);

/// Returns the lowest level whose error is within the tolerance; 64 if there is none. `errors` are the errors of the
/// levels 1, 2, 4, ... 64, non-increasing. Between two levels the error is linear in the level's logarithm.
double level_by_error(const std::array<double, 7>& errors, double tolerance);

/// Return the levels of the edges in the order of gl_TessLevelOuter. Edge i goes from corner i to the next.
glm::dvec4 outer_levels_of_triangle(const glm::dvec3& edges);
glm::dvec4 outer_levels_of_quad(const glm::dvec4& edges);

/// Returns a bounding sphere (centre, radius) of a displaced patch. `flat` is the bounding sphere of the flat patch.
/// Its points move by scale (h - 1), lowest <= h <= highest, along unit vectors that differ from `axis` by at most
/// `spread`.
glm::dvec4 relief_bounds(const glm::dvec4& flat, const glm::dvec3& axis, double spread, double lowest, double highest,
                         double scale);

/// Returns whether the sphere lies entirely behind one of the planes. A plane's xyz has unit length and points into the
/// frustum.
bool is_outside(std::span<const glm::dvec4> planes, const glm::dvec4& sphere);

/// Returns whether all triangles in the sphere face away from the eye. Precondition: their normals are within
/// atan(slope) of `axis`. This is the cone of normals of Shirman and Abi-Ezzi (1993). Never true if the eye is in the
/// sphere.
bool faces_away(const glm::dvec3& axis, double slope, const glm::dvec4& sphere, const glm::dvec3& eye);

/// Returns the remaining share of the displacement at a distance: 1 up to `begin`, 0 from `end` on, linear between.
/// Precondition: begin < end.
double remaining(double distance, double begin, double end);

}  // namespace relief
