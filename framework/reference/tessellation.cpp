#include "framework/reference/tessellation.h"

#include <algorithm>
#include <cmath>

namespace relief {

double possible_level(double level) { return level > 1 ? std::min(level, max_tessellation_level) : 1; }

double level_by_distance(double distance, double nearest, double farthest, double finest, double coarsest) {
    const double share = std::clamp((distance - nearest) / (farthest - nearest), 0.0, 1.0);
    return possible_level(std::exp2(finest + (coarsest - finest) * share));
}

double level_by_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double pixels_per_radian,
                     double pixels_per_segment) {
    const double pixels = glm::length(a - b) * pixels_per_radian / glm::length((a + b) * 0.5 - eye);
    return possible_level(pixels / pixels_per_segment);
}

double level_by_error(double length, double curvature, double distance, double pixels_per_radian, double budget) {
    return possible_level(length * std::sqrt(std::abs(curvature) * pixels_per_radian / (8 * budget * distance)));
}

}  // namespace relief
