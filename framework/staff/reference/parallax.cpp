#include "framework/staff/reference/parallax.h"

#include <algorithm>

namespace relief {
namespace {

ParallaxHit hit_at(const ReliefRay& ray, double t, int taps) { return {t, ray.texel + t * ray.march, taps}; }

/// Returns the height of the ray above the surface.
double gap(const HeightField& field, const ReliefRay& ray, double t) {
    return 1 - t - field.height(ray.texel + t * ray.march);
}

}  // namespace

ParallaxHit parallax_offset(const HeightField& field, const ReliefRay& ray) {
    return hit_at(ray, 1 - field.height(ray.texel), 1);
}

ParallaxHit offset_limited(const HeightField& field, const ReliefRay& ray) {
    return hit_at(ray, (1 - field.height(ray.texel)) * ray.slant, 1);
}

ParallaxHit steep_parallax(const HeightField& field, const ReliefRay& ray, double steps) {
    return march(field, ray, steps, Refinement::none, 0);
}

ParallaxHit march(const HeightField& field, const ReliefRay& ray, double steps, Refinement refinement, int rounds) {
    const double step = 1 / std::max(1.0, steps);
    double before = 0, after = 0, gap_before = gap(field, ray, 0), gap_after = gap_before;
    int taps = 1;
    while (gap_after > 0 && after < 1) {
        before = after, gap_before = gap_after;
        after = std::min(1.0, after + step);
        gap_after = gap(field, ray, after), ++taps;
    }
    if (gap_before <= 0) return hit_at(ray, before, taps);
    if (refinement == Refinement::none) return hit_at(ray, after, taps);
    // The line between the two ends crosses zero at this share: gap_before > 0 and gap_after <= 0 always hold.
    const auto crossing = [&](double weight_before, double weight_after) {
        const double above = gap_before * weight_before, below = -gap_after * weight_after;
        return before + (after - before) * above / (above + below);
    };
    double weight_before = 1, weight_after = 1;  // Illinois: an end that stays twice has half the weight
    int stayed = 0;
    for (int round = 0; refinement != Refinement::linear && round < rounds; ++round) {
        const double t =
            refinement == Refinement::bisection ? (before + after) / 2 : crossing(weight_before, weight_after);
        const double gap_here = gap(field, ray, t);
        ++taps;
        if (gap_here > 0) {
            before = t, gap_before = gap_here, weight_before = 1;
            weight_after = refinement == Refinement::illinois && stayed == 1 ? weight_after / 2 : 1;
            stayed = 1;
        } else {
            after = t, gap_after = gap_here, weight_after = 1;
            weight_before = refinement == Refinement::illinois && stayed == -1 ? weight_before / 2 : 1;
            stayed = -1;
        }
    }
    return hit_at(ray, crossing(1, 1), taps);
}

}  // namespace relief
