#include "framework/staff/reference/least_move.h"

#include <algorithm>
#include <cmath>

#include "framework/core/base/parallel.h"

namespace relief {
namespace {

/// Returns the next t at which one of the ray's coordinates enters another cell; cells meet at texel centres.
double next_line(double origin, double along, double t) {
    if (along == 0) return INFINITY;
    const double place = origin - 0.5 + t * along, nearest = std::round(place);
    // A line that the ray is on, up to rounding, counts as passed.
    const double line = std::abs(place - nearest) < 1e-9 * (1 + std::abs(place)) ? nearest + (along > 0 ? 1 : -1)
                        : along > 0                                              ? std::ceil(place)
                                                                                 : std::floor(place);
    return (line + 0.5 - origin) / along;
}

}  // namespace

ReliefMove least_move(const HeightField& field, const Ray& ray, double t) {
    const auto above = [&](double at) {  // height of the relief above the ray
        const glm::dvec3 p = ray.at(at);
        return field.height(glm::dvec2(p)) - p.z;
    };
    const double begin = std::max(0.0, (field.highest() - ray.origin.z) / ray.direction.z);
    t = std::clamp(t, 0.0, std::max(begin, (field.lowest() - ray.origin.z) / ray.direction.z));
    ReliefMove largest{t, -above(t)};
    const auto consider = [&](double at, double height) {
        if (height > std::abs(largest.height)) largest = {at, -height};
    };
    for (double from = begin, before = above(from); from < t;) {
        const double to = std::min(
            {next_line(ray.origin.x, ray.direction.x, from), next_line(ray.origin.y, ray.direction.y, from), t});
        // Within a cell the height is a quadratic in s in [0, 1], given by its ends and its middle.
        const double middle = above((from + to) / 2), after = above(to);
        const double bend = 2 * (before + after) - 4 * middle, slope = after - before - bend;
        consider(from, before), consider(to, after);
        if (const double s = -slope / (2 * bend); bend < 0 && s > 0 && s < 1)
            consider(from + s * (to - from), before + s * (slope + s * bend));
        from = to, before = after;
    }
    return largest;
}

std::vector<ShownError> wall_errors(const Image& texels, const HeightField& field, double texels_per_metre,
                                    double scale, const glm::dmat4& clip_from_world) {
    const glm::dmat4 world_from_clip = glm::inverse(clip_from_world);
    const glm::dvec2 size(texels.width, texels.height);
    const auto world = [&](glm::dvec2 ndc, double depth) {
        const glm::dvec4 point = world_from_clip * glm::dvec4(ndc, depth, 1);
        return glm::dvec3(point) / point.w;
    };
    const auto pixel_of = [&](const glm::dvec3& point) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(point, 1);
        return glm::dvec2(clip) / clip.w * size / 2.0;
    };
    std::vector<std::vector<ShownError>> rows(size_t(texels.height));
    parallel_each(rows.size(), 0, [&](size_t y) {
        for (int x = 0; x < texels.width; ++x) {
            const float* const shown = texels.pixel(x, int(y));
            if (!std::isfinite(shown[0])) continue;
            const glm::dvec2 ndc((x + 0.5) / size.x * 2 - 1, 1 - (double(y) + 0.5) / size.y * 2);
            const glm::dvec3 near = world(ndc, -1), way = world(ndc, 0) - near;
            const glm::dvec2 front = near + way * (near.z / -way.z), along = glm::dvec2(way) * (scale / -way.z);
            const glm::dvec2 texel{shown[0], shown[1]};
            const double length2 = glm::dot(along, along);
            const double t = length2 > 0 ? glm::dot(texel / texels_per_metre - front, along) / length2 : 0;
            const ReliefMove move =
                least_move(field, {{front * texels_per_metre, 1}, {along * texels_per_metre, -1}}, t);
            const glm::dvec3 on_ray(front + move.t * along, -scale * move.t);
            rows[y].push_back(
                {{x, int(y)},
                 texel,
                 1 - t,
                 glm::distance(pixel_of(on_ray), pixel_of(on_ray + glm::dvec3(0, 0, scale * move.height)))});
        }
    });
    std::vector<ShownError> all;
    for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
    return all;
}

}  // namespace relief
