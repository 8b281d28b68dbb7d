// The staff's part of lab 17: see ../truth.h.
#include "truth.h"

#include <cmath>

#include "framework/library/kit/drawn_numbers.h"
#include "framework/staff/reference/budget.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/near_plane.h"

namespace relief::budget {
namespace {

std::optional<Image> exact_values(const FrameBudget& budget, const MapErrors& maps, const Image& heights) {
    const Probe& probe = budget.frame.probe;
    const bool uv = probe.name == "uv", pixels = probe.name == "pixels", left = probe.name == "left";
    const bool level = probe.name == "level", bumps = probe.name == "bumps";
    if (!uv && !pixels && !left && !level && !bumps) return {};
    const HeightField field(heights, true);
    const glm::dvec2 size(field.size());
    const glm::dmat4 clip_from_world = budget.frame.camera.clip_from_world();
    return truth_of_rays(budget.frame, [&](const Ray& ray) -> std::optional<glm::dvec4> {
        const double away = -ray.origin.z / ray.direction.z;
        if (!(away > near_plane(clip_from_world, ray)) || ray.direction.z >= 0) return {};
        const glm::dvec3 front = ray.at(away);
        if (!glm::all(glm::lessThanEqual(wall_low, glm::dvec2(front))) ||
            !glm::all(glm::lessThanEqual(glm::dvec2(front), wall_high)))
            return {};
        if (uv) {
            const glm::dvec2 along = glm::dvec2(ray.direction) * (budget.scale / -ray.direction.z);
            const auto hit = field.first_hit({{glm::dvec2(front) * size, 1}, {along * size, -1}}, 1);
            const glm::dvec2 place = glm::dvec2(front) + (hit ? hit->t : 1) * along;
            if (glm::any(glm::lessThan(place, wall_low)) || glm::any(glm::greaterThan(place, wall_high))) return {};
            return glm::dvec4(place * size, 0, 0);
        }
        const glm::dvec4 clip = clip_from_world * glm::dvec4(front, 1);
        const double metre = pixels_per_metre(clip, clip_from_world[2], glm::dvec2(budget.frame.size));
        const double max_error = tolerated(budget.pixels, metre, budget.scale);
        if (pixels) return glm::dvec4(metre * budget.scale, 0, 0, 0);
        if (left)
            return glm::dvec4(thinned(double(maps.range.x), double(maps.range.y), budget.thinning * max_error), 0, 0);
        if (level) return glm::dvec4(coarsest_level(maps.levels, budget.precision * max_error), 0, 0, 0);
        const double read = std::max(0.0, first_level(budget, maps) + 1.5 * std::log2(clip.w));
        return glm::dvec4(bumps_left(read, double(maps.flat_level), budget.pixels), 0, 0, 0);
    });
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::budget
