#include "framework/staff/reference/displaced_wall.h"

#include <algorithm>
#include <limits>

namespace relief {
namespace {

/// The part of a ray within a box, in metres along the ray. It is empty if `begin` is greater than `end`.
struct BoxStretch {
    double begin = 0, end = std::numeric_limits<double>::infinity();
};
BoxStretch stretch_within(const Ray& ray, const glm::dvec3& low, const glm::dvec3& high) {
    BoxStretch inside;
    for (int i = 0; i < 3; ++i) {
        double enters = (low[i] - ray.origin[i]) / ray.direction[i];
        double leaves = (high[i] - ray.origin[i]) / ray.direction[i];
        if (enters > leaves) std::swap(enters, leaves);
        if (ray.direction[i] == 0) {
            if (ray.origin[i] < low[i] || ray.origin[i] > high[i]) return {1, 0};
            continue;
        }
        inside.begin = std::max(inside.begin, enters), inside.end = std::min(inside.end, leaves);
    }
    return inside;
}

Image upside_down(Image heights) {
    for (float& value : heights.values) value = 1 - value;
    return heights;
}

}  // namespace

DisplacedWall::DisplacedWall(const Image& heights, double metres, double tiles, double scale)
    : above_(heights, true),
      below_(upside_down(heights), true),
      metres_(metres),
      scale_(scale),
      tiles_(tiles / metres),
      texels_(tiles / metres * glm::dvec2(above_.size())) {}

std::optional<DisplacedWall::Seen> DisplacedWall::look(const Ray& ray, double begin) const {
    const double half = metres_ / 2;
    BoxStretch stretch = stretch_within(ray, {-half, -half, -scale_}, {half, half, 0});
    stretch.begin = std::max(stretch.begin, begin);
    if (stretch.begin > stretch.end) return {};
    if (scale_ == 0) return seen(stretch.begin, at_texel(ray, stretch.begin));
    const glm::dvec3 enters = ray.origin + stretch.begin * ray.direction;
    const glm::dvec3 unit(texels_, 1 / scale_);  // texels and heights per metre
    Ray inside{(enters + glm::dvec3(half, half, scale_)) * unit, ray.direction * unit};
    const bool from_below = inside.origin.z < above_.height(inside.origin);
    if (from_below) inside.origin.z = 1 - inside.origin.z, inside.direction.z = -inside.direction.z;
    const auto hit = (from_below ? below_ : above_).first_hit(inside, stretch.end - stretch.begin);
    if (!hit) return {};
    return seen(stretch.begin + hit->t, hit->texel);
}

glm::dvec2 DisplacedWall::at_texel(const Ray& ray, double t) const {
    return (glm::dvec2(ray.origin + t * ray.direction) + metres_ / 2) * texels_;
}

DisplacedWall::Seen DisplacedWall::seen(double t, glm::dvec2 texel) const {
    // Fragments compute the slope by the same central difference.
    const glm::dvec2 slope = above_.central_slope(texel) * glm::dvec2(above_.size());
    return {t, slope, glm::normalize(glm::dvec3(-slope * tiles_ * scale_, 1))};
}

}  // namespace relief
