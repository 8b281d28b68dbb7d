#include "patches.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <tuple>

#include "task.h"

namespace relief::planet {

const PatchedSphere& patches_of(const Shape& shape) {
    static std::mutex lock;
    static std::map<std::tuple<int, int, float, int, int>, PatchedSphere> known;
    const std::lock_guard hold(lock);
    const Ground& ground = shape.ground;
    return known
        .try_emplace({ground.seed, ground.detail, ground.height, int(shape.mapping), shape.quads}, shape.mapping,
                     shape.quads, [ground](const glm::dvec3& r) { return height(ground, r); })
        .first->second;
}

Rules students_rules() { return {split_distance, skirt_depth, behind_horizon}; }

namespace {

/// Returns the distance in radii within which a patch of a level is split.
double split_radii(const Plan& plan, const Rules& rules, int level) {
    if (plan.levels == Levels::uniform) return level < plan.level ? INFINITY : -1;
    if (plan.levels == Levels::distance) return 6 / (plan.budget * (1 << level));
    const double error = patches_of(plan.shape).usual_errors()[size_t(level)] * plan.radius;
    return rules.split_distance(error, plan.budget, plan.pixels, plan.eye.field_of_view_rad) / plan.radius;
}

Leaf::State state_of(const Plan& plan, const Rules& rules, const PatchBounds& bounds) {
    const double from_centre = glm::length(plan.eye.place);
    if (plan.cull == Cull::horizon && from_centre > 0) {
        const double apart = std::acos(std::clamp(glm::dot(plan.eye.place, bounds.direction) / from_centre, -1.0, 1.0));
        if (rules.behind_horizon(from_centre * plan.radius, std::max(0.0, apart - bounds.angle), plan.radius,
                                 plan.radius * (1 + bounds.highest)))
            return Leaf::hidden;
    }
    const bool is_outside = plan.cull != Cull::none && plan.eye.misses(bounds.middle, bounds.radius);
    return is_outside ? Leaf::outside : Leaf::drawn;
}

}  // namespace

Cover cover(const Plan& plan, const Rules& rules) {
    const PatchedSphere& patches = patches_of(plan.shape);
    std::array<double, deepest_level> within{};
    for (int level = 0; level < deepest_level; ++level) within[size_t(level)] = split_radii(plan, rules, level);
    return cover_sphere(plan.shape.mapping, plan.most_patches, [&](const SpherePatch& id) -> PatchNeed {
        const PatchBounds bounds = patches.bounds(id);
        const double away = std::max(0.0, glm::distance(plan.eye.place, bounds.middle) - bounds.radius);
        const double need = id.level < deepest_level ? within[size_t(id.level)] / away : 0;
        return {state_of(plan, rules, bounds), std::isnan(need) ? INFINITY : need};
    });
}

}  // namespace relief::planet
