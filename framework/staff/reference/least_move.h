// The error of a claimed hit: how far the relief would have to move to make the hit correct.
#pragma once

#include <vector>

#include "framework/staff/reference/height_field.h"

namespace relief {

/// The largest move of the relief that a claimed hit requires, and its position along the ray.
struct ReliefMove {
    double t;       ///< in multiples of the ray's direction
    double height;  ///< up is positive
};

/// Returns the error of the claim that the ray first meets the relief at t. The ray's x and y are in texels, z is a
/// height, and the ray goes down. t is clamped to [0, t_end], where t_end is the point at which the ray reaches the
/// lowest height.
///
/// The claim is correct if the relief has the ray's height at t and is nowhere above the ray before t. Otherwise the
/// error is the larger of two moves. One is the relief's distance from the ray at t. The other is its maximum height
/// above the ray before t. So the error of a hidden point is the height of the occluder above the ray.
///
/// A method whose heights are wrong by at most e has an error of at most e, regardless of occlusion. This is the
/// texture deviation of Cohen, Olano and Manocha (1998), measured from the ray.
ReliefMove least_move(const HeightField& field, const Ray& ray, double t);

/// The same error on the screen.
struct ShownError {
    glm::ivec2 pixel;  ///< from the upper left corner
    glm::dvec2 texel;  ///< the position that the pixel shows
    double height;     ///< of the view ray at that position
    double pixels;     ///< the relief's move, in pixels of this picture
};

/// Returns the errors of all pixels that show a wall, row by row. The wall lies in the plane z = 0 and faces +z; its
/// relief is `scale` metres deep and lies behind the plane. The map has a corner at the origin and `texels_per_metre`.
/// The first two channels of `texels` hold the position that each pixel shows, or no_surface.
std::vector<ShownError> wall_errors(const Image& texels, const HeightField& field, double texels_per_metre,
                                    double scale, const glm::dmat4& clip_from_world);

}  // namespace relief
