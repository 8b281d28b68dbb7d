#include "framework/course/inspect/seam.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace relief::inspect {
namespace {

double step(float a, float b) { return std::abs(double(a) - b); }
double step(glm::vec3 a, glm::vec3 b) { return angle_between(a, b); }

/// Measures `count` lines of `length` texels; texel j of line i is at i * line + j * texel.
template <class Value>
BorderSteps steps(std::span<const Value> values, int count, int length, size_t line, size_t texel) {
    BorderSteps result;
    if (count < 4 || length < 4) return result;
    double sum = 0;
    int lines = 0;
    std::vector<double> some;  // single-texel steps within the map
    const size_t stride = std::max<size_t>(1, values.size() / 50000);
    for (int i = 0; i < count; ++i) {
        const int next = (i + 1) % count;
        double mean = 0, worst = 0;
        int texels = 0;
        for (int j = 0; j < length; ++j) {
            const double one =
                step(values[size_t(i) * line + size_t(j) * texel], values[size_t(next) * line + size_t(j) * texel]);
            if (std::isnan(one)) continue;
            mean += one, worst = std::max(worst, one), ++texels;
            if (next != 0 && (size_t(i) * size_t(length) + size_t(j)) % stride == 0) some.push_back(one);
        }
        if (texels == 0) continue;
        mean /= texels;
        if (next == 0) {
            result.across = mean, result.worst = worst, result.tells = lines > 0;
        } else {
            sum += mean, ++lines;
            result.largest = std::max(result.largest, mean);
            if (std::min(i, count - 2 - i) < 4) result.nearby = std::max(result.nearby, mean);
        }
    }
    if (lines > 0) result.within = sum / lines;
    if (!some.empty()) {
        const auto at = some.begin() + std::ptrdiff_t(0.999 * double(some.size() - 1));
        std::nth_element(some.begin(), at, some.end());
        result.sharp = *at;
    }
    // A border that continues is like any other line, so its step hardly exceeds the largest step elsewhere.
    result.fits = !result.tells || result.across <= 2 * result.within || result.across <= 1.1 * result.largest;
    return result;
}

}  // namespace

double angle_between(glm::dvec3 a, glm::dvec3 b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 180 / std::numbers::pi;
}

BorderSteps steps_across_sides(std::span<const glm::vec3> vectors, int width, int height) {
    return steps(vectors, width, height, 1, size_t(width));
}
BorderSteps steps_across_top(std::span<const glm::vec3> vectors, int width, int height) {
    return steps(vectors, height, width, size_t(width), 1);
}
BorderSteps steps_across_sides(std::span<const float> heights, int width, int height) {
    return steps(heights, width, height, 1, size_t(width));
}
BorderSteps steps_across_top(std::span<const float> heights, int width, int height) {
    return steps(heights, height, width, size_t(width), 1);
}

}  // namespace relief::inspect
