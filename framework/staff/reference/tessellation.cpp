#include "framework/staff/reference/tessellation.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace relief {

double possible_level(double level) { return level > 1 ? std::min(level, max_tessellation_level) : 1; }

double level_by_distance(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double nearest,
                         double farthest, double finest, double coarsest) {
    const double away = glm::distance((a + b) * 0.5, eye);
    return possible_level(std::exp2(finest + (coarsest - finest) * (1 - remaining(away, nearest, farthest))));
}

double level_by_size(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& eye, double pixels_per_radian,
                     double pixels_per_segment) {
    const double pixels = glm::length(a - b) * pixels_per_radian / glm::length((a + b) * 0.5 - eye);
    return possible_level(pixels / pixels_per_segment);
}

double tolerated(double distance, double pixels_per_radian, double budget, double scale) {
    return scale > 0 ? budget * distance / (pixels_per_radian * scale) : 1e30;
}

double level_by_error(const std::array<double, 7>& errors, double tolerance) {
    for (size_t octave = 0; octave < errors.size(); ++octave) {
        if (errors[octave] > tolerance) continue;
        if (octave == 0) return 1;
        const double share = (errors[octave - 1] - tolerance) / (errors[octave - 1] - errors[octave]);
        return std::exp2(double(octave - 1) + share);
    }
    return max_tessellation_level;
}

glm::dvec4 outer_levels_of_triangle(const glm::dvec3& edges) { return {edges.y, edges.z, edges.x, 0}; }

glm::dvec4 outer_levels_of_quad(const glm::dvec4& edges) { return {edges.w, edges.x, edges.y, edges.z}; }

glm::dvec4 relief_bounds(const glm::dvec4& flat, const glm::dvec3& axis, double spread, double lowest, double highest,
                         double scale) {
    const double low = scale * (lowest - 1), high = scale * (highest - 1);
    return {glm::dvec3(flat) + axis * ((low + high) / 2),
            flat.w + (high - low) / 2 + std::max(std::abs(low), std::abs(high)) * spread};
}

bool is_outside(std::span<const glm::dvec4> planes, const glm::dvec4& sphere) {
    return std::any_of(planes.begin(), planes.end(), [&](const glm::dvec4& plane) {
        return glm::dot(plane, {glm::dvec3(sphere), 1}) < -sphere.w;
    });
}

bool faces_away(const glm::dvec3& axis, double slope, const glm::dvec4& sphere, const glm::dvec3& eye) {
    const glm::dvec3 away = glm::dvec3(sphere) - eye;
    const double distance = glm::length(away);
    if (!(distance > sphere.w)) return false;
    const double between = std::acos(std::clamp(glm::dot(axis, away) / distance, -1.0, 1.0));
    return between + std::atan(slope) + std::asin(sphere.w / distance) < glm::half_pi<double>();
}

double remaining(double distance, double begin, double end) {
    return std::clamp((end - distance) / (end - begin), 0.0, 1.0);
}

}  // namespace relief
