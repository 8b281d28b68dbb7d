// The error of a claimed hit: by how much the relief would have to move to make it
// right.
#pragma once

#include <vector>

#include "framework/staff/reference/height_field.h"

namespace relief {

/// Where along a ray the relief would have to move the most, and by how much: up is positive.
struct ReliefMove {
    double t;
    double height;
};

/// The ray (x and y in texels, z in heights, going down) is said to meet the relief first at t, as a shader has it.
/// Then the relief must be there, at the ray's height, and nowhere before that above the ray. If that is so, it has to
/// move by nothing; else by its distance from the ray at t, or by how far it rises above the ray before t, whichever is
/// larger. So the error of a hidden place is the height of what hides it above the ray. A t below 0 or beyond t_end is
/// taken for these, t_end being where the ray has reached the lowest height.
///
/// With this a method that shows a relief whose heights are off by e at most is off by e at most, whatever hides what:
/// the texture deviation of Cohen, Olano and Manocha (1998), measured from the ray.
ReliefMove least_move(const HeightField& field, const Ray& ray, double t);

/// The same on the screen.
struct ShownError {
    glm::ivec2 pixel;  ///< from the upper left corner
    glm::dvec2 texel;  ///< that it shows
    double height;     ///< at which it shows it: that of the view ray there
    double pixels;     ///< that the relief would have to move, as this picture has it
};

/// Of each pixel that shows a wall in the plane z = 0, which faces +z and has a relief behind it, `scale` metres deep:
/// row by row. `texels` holds the place that a pixel shows in its first two channels, and no_surface elsewhere; the map
/// lies with a corner at the origin and a metre is `texels_per_metre` wide.
std::vector<ShownError> wall_errors(const Image& texels, const HeightField& field, double texels_per_metre,
                                    double scale, const glm::dmat4& clip_from_world);

}  // namespace relief
