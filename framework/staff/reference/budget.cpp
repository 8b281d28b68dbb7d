#include "framework/staff/reference/budget.h"

#include <algorithm>
#include <cmath>

namespace relief {

double pixels_per_metre(const glm::dvec4& clip, const glm::dvec4& along, const glm::dvec2& size) {
    // (x / w)' = (x' w - x w') / w²
    const glm::dvec2 slope = (glm::dvec2(along) * clip.w - glm::dvec2(clip) * along.w) / (clip.w * clip.w);
    return glm::length(slope * size / 2.0);
}

double tolerated(double budget, double pixels_per_metre, double scale) {
    return scale * pixels_per_metre > 0 ? budget / pixels_per_metre / scale : 1e30;
}

glm::dvec2 thinned(double lowest, double highest, double max_cut) {
    const double cut = std::min(max_cut, (highest - lowest) / 2);
    return {lowest + cut, highest - cut};
}

double coarsest_level(std::span<const float> errors, double tolerance) {
    for (size_t k = errors.size(); k-- > 0;) {
        const double here = double(errors[k]);
        if (here > tolerance) continue;
        if (k + 1 == errors.size()) return double(k);
        return double(k) + (tolerance - here) / (double(errors[k + 1]) - here);
    }
    return 0;
}

double bumps_left(double level, double flat_level, double budget) {
    return std::clamp(flat_level - std::log2(std::exp2(level) * budget), 0.0, 1.0);
}

}  // namespace relief
