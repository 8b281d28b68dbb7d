// What only the staff has of lab 17: see ../truth.h.
#include "truth.h"

#include <cmath>

#include "framework/base/parallel.h"
#include "framework/staff/reference/budget.h"
#include "framework/staff/reference/height_field.h"

namespace relief::budget {
namespace {

std::optional<Image> exact_values(const Probe& probe, const FrameBudget& budget, const MapErrors& maps,
                                  const Image& heights) {
    const bool uv = probe.name == "uv", pixels = probe.name == "pixels", left = probe.name == "left";
    const bool level = probe.name == "level", bumps = probe.name == "bumps";
    if (!uv && !pixels && !left && !level && !bumps) return {};
    const HeightField field(heights, true);
    const glm::dvec2 size(field.size());
    const glm::dmat4 clip_from_world = budget.frame.camera.clip_from_world();
    Image image(budget.frame.size.x, budget.frame.size.y, 4);
    std::fill(image.values.begin(), image.values.end(), no_surface);
    const auto draw = [&](int x, int y) {
        const Ray ray = budget.frame.ray(x, y);
        const double away = -ray.origin.z / ray.direction.z;
        if (!(away > 0) || ray.direction.z >= 0) return;
        const glm::dvec3 front = ray.at(away);
        if (!glm::all(glm::lessThanEqual(wall_low, glm::dvec2(front))) ||
            !glm::all(glm::lessThanEqual(glm::dvec2(front), wall_high)))
            return;
        float* const pixel = image.pixel(x, y);
        if (uv) {
            const glm::dvec2 along = glm::dvec2(ray.direction) * (budget.scale / -ray.direction.z);
            const auto hit = field.first_hit({{glm::dvec2(front) * size, 1}, {along * size, -1}}, 1);
            const glm::dvec2 place = glm::dvec2(front) + (hit ? hit->t : 1) * along;
            if (glm::any(glm::lessThan(place, wall_low)) || glm::any(glm::greaterThan(place, wall_high))) return;
            std::fill_n(pixel, 4, 0.0f);
            pixel[0] = float(place.x * size.x), pixel[1] = float(place.y * size.y);
            return;
        }
        std::fill_n(pixel, 4, 0.0f);
        const glm::dvec4 clip = clip_from_world * glm::dvec4(front, 1);
        const double metre = pixels_per_metre(clip, clip_from_world[2], glm::dvec2(budget.frame.size));
        const double max_error = tolerated(budget.pixels, metre, budget.scale);
        if (pixels) pixel[0] = float(metre * budget.scale);
        if (left) {
            const glm::dvec2 between = thinned(double(maps.range.x), double(maps.range.y), budget.thinning * max_error);
            pixel[0] = float(between.x), pixel[1] = float(between.y);
        }
        if (level) pixel[0] = float(coarsest_level(maps.levels, budget.precision * max_error));
        if (bumps) {
            const double read = std::max(0.0, first_level(budget, maps) + 1.5 * std::log2(clip.w));
            pixel[0] = float(bumps_left(read, double(maps.flat_level), budget.pixels));
        }
    };
    parallel_pieces(size_t(image.height), 1, 0, [&](size_t begin, size_t end) {
        for (size_t y = begin; y < end; ++y)
            for (int x = 0; x < image.width; ++x) draw(x, int(y));
    });
    return image;
}

const decltype(truth)::Provided provided_truth(truth, exact_values);

}  // namespace
}  // namespace relief::budget
