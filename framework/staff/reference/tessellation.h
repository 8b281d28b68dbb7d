// How finely an edge of a patch is to be cut, and which patches nobody sees, in double precision. Twins of the
// functions in shaders/14_adaptive_displacement/task.glsl.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

namespace relief {

/// What GL 4 can do.
constexpr double max_tessellation_level = 64;

/// The level within 1 to 64; one that is not a number becomes 1.
double possible_level(double level);

/// 2^finest where the middle of an edge is `nearest` metres from the eye, or nearer, 2^coarsest at `farthest` or
/// farther, the exponent linear between (Luna 2012). nearest < farthest.
double level_by_distance(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double nearest,
                         double farthest, double finest, double coarsest);

/// The edge's length as the diameter of a sphere around its middle, in pixels of the screen, over the pixels that one
/// segment may have; from 1 to 64. It does not fall when the edge turns towards the eye. `pixels_per_radian` is the
/// picture's height in pixels over 2 tan(field of view / 2).
double level_by_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double pixels_per_radian,
                     double pixels_per_segment);

/// By how much a height in [0, 1] may be off, `distance` metres away, where the screen may show `budget` pixels of it.
/// A relief without depth tolerates anything, 1e30.
double tolerated(double distance, double pixels_per_radian, double budget, double scale);

/// The least level whose error is tolerated, 64 where none is. `errors` are those of levels 1, 2, 4, ... 64 and never
/// rise; between two levels the error is linear over the exponent of 2.
double level_by_error(const std::array<double, 7>& errors, double tolerance);

/// Edge i goes from corner i to the next: in the order of gl_TessLevelOuter.
glm::dvec4 outer_levels_of_triangle(const glm::dvec3& edges);
glm::dvec4 outer_levels_of_quad(const glm::dvec4& edges);

/// A sphere (centre, radius) around all that becomes of a flat patch within the sphere `flat` when its places move by
/// scale (h - 1), lowest <= h <= highest, along unit vectors that differ from `axis` by `spread` at most.
glm::dvec4 relief_bounds(const glm::dvec4& flat, const glm::dvec3& axis, double spread, double lowest, double highest,
                         double scale);

/// Whether a sphere is wholly behind one of the planes; xyz has unit length and points into the picture.
bool is_outside(std::span<const glm::dvec4> planes, const glm::dvec4& sphere);

/// Whether triangles in a sphere, whose normals are within atan(slope) of `axis`, all show their backs: a cone of
/// normals (Shirman and Abi-Ezzi 1993). Never while the eye is in the sphere.
bool faces_away(const glm::dvec3& axis, double slope, const glm::dvec4& sphere, const glm::dvec3& eye);

/// How much of the displacement is left: 1 up to `begin`, 0 from `end` on, linear between. begin < end.
double remaining(double distance, double begin, double end);

}  // namespace relief
