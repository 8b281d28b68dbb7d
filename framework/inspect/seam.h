// Whether the left border of a map continues the right one, and the top the bottom.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace relief {

/// Steps between neighbours: angles in degrees between vectors, differences between heights. A column's step to the
/// next is the mean over its texels.
struct BorderSteps {
    double across = 0;   ///< from the last column to the first
    double within = 0;   ///< from a column to the next, mean
    double largest = 0;  ///< the largest of those
    double nearby = 0;   ///< the largest of the four nearest to the border on either side
    double worst = 0;    ///< of a single texel across the border
    double sharp = 0;    ///< of single texels within, the 99.9 % quantile
    bool tells = false;  ///< four columns and rows at least, and texels on both sides
    bool fits = true;    ///< the border is not a larger step than others of the map

    bool fits_nearby() const { return !tells || across <= 2 * within || across <= 1.5 * nearby; }
};

/// NaN in x: no vector there. They need not be unit.
BorderSteps steps_across_sides(std::span<const glm::vec3> vectors, int width, int height);
BorderSteps steps_across_top(std::span<const glm::vec3> vectors, int width, int height);
/// NaN: no height there.
BorderSteps steps_across_sides(std::span<const float> heights, int width, int height);
BorderSteps steps_across_top(std::span<const float> heights, int width, int height);

/// In degrees.
double angle_between(glm::dvec3 a, glm::dvec3 b);

}  // namespace relief
