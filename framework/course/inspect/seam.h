// Tests whether a map repeats: its left border continues the right one, and its top the bottom.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace relief::inspect {

/// Steps between neighbouring texels: angles in degrees between vectors, or differences between heights. A column's
/// step to the next column is the mean over its texels. For the top border, read rows for columns.
struct BorderSteps {
    double across = 0;   ///< from the last column to the first
    double within = 0;   ///< from one column to the next, mean over the map
    double largest = 0;  ///< the largest step between columns
    double nearby = 0;   ///< the largest among the four columns nearest to the border on either side
    double worst = 0;    ///< the largest step of a single texel across the border
    double sharp = 0;    ///< 99.9 % quantile of single-texel steps within the map
    bool tells = false;  ///< at least four columns and rows, with texels on both sides of the border
    bool fits = true;    ///< the step at the border is no larger than others in the map

    bool fits_nearby() const { return !tells || across <= 2 * within || across <= 1.5 * nearby; }
};

/// NaN in x marks a texel without a vector. Vectors need not have unit length.
BorderSteps steps_across_sides(std::span<const glm::vec3> vectors, int width, int height);
BorderSteps steps_across_top(std::span<const glm::vec3> vectors, int width, int height);
/// NaN marks a texel without a height.
BorderSteps steps_across_sides(std::span<const float> heights, int width, int height);
BorderSteps steps_across_top(std::span<const float> heights, int width, int height);

/// Returns the angle in degrees, in [0, 180].
double angle_between(glm::dvec3 a, glm::dvec3 b);

}  // namespace relief::inspect
