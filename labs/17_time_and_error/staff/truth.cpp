// What only the staff has of lab 17: see ../truth.h.
#include "truth.h"

#include <cmath>

#include "framework/base/parallel.h"
#include "framework/staff/reference/budget.h"
#include "framework/staff/reference/height_field.h"

namespace relief::budget {
namespace {

std::optional<Image> exact_values(const Probe& probe, const Question& question, const Known& known,
                                  const Image& heights) {
    const bool uv = probe.name == "uv", pixels = probe.name == "pixels", left = probe.name == "left";
    const bool level = probe.name == "level", bumps = probe.name == "bumps";
    if (!uv && !pixels && !left && !level && !bumps) return {};
    const HeightField field(heights, true);
    const glm::dvec2 size(field.size());
    const glm::dmat4 clip_from_world = question.frame.camera.clip_from_world();
    Image image(question.frame.size.x, question.frame.size.y, 4);
    std::fill(image.values.begin(), image.values.end(), no_surface);
    const auto draw = [&](int x, int y) {
        const Ray ray = question.frame.ray(x, y);
        const double away = -ray.origin.z / ray.direction.z;
        if (!(away > 0) || ray.direction.z >= 0) return;
        const glm::dvec3 front = ray.at(away);
        if (!glm::all(glm::lessThanEqual(wall_low, glm::dvec2(front))) ||
            !glm::all(glm::lessThanEqual(glm::dvec2(front), wall_high)))
            return;
        float* const pixel = image.pixel(x, y);
        if (uv) {
            const glm::dvec2 along = glm::dvec2(ray.direction) * (question.scale / -ray.direction.z);
            const auto hit = field.first_hit({{glm::dvec2(front) * size, 1}, {along * size, -1}}, 1);
            const glm::dvec2 place = glm::dvec2(front) + (hit ? hit->t : 1) * along;
            if (glm::any(glm::lessThan(place, wall_low)) || glm::any(glm::greaterThan(place, wall_high))) return;
            std::fill_n(pixel, 4, 0.0f);
            pixel[0] = float(place.x * size.x), pixel[1] = float(place.y * size.y);
            return;
        }
        std::fill_n(pixel, 4, 0.0f);
        const glm::dvec4 clip = clip_from_world * glm::dvec4(front, 1);
        const double metre = pixels_per_metre(clip, clip_from_world[2], glm::dvec2(question.frame.size));
        const double most = tolerated(question.budget, metre, question.scale);
        if (pixels) pixel[0] = float(metre * question.scale);
        if (left) {
            const glm::dvec2 between = thinned(double(known.range.x), double(known.range.y), question.thinning * most);
            pixel[0] = float(between.x), pixel[1] = float(between.y);
        }
        if (level) pixel[0] = float(coarsest_level(known.levels, question.precision * most));
        if (bumps) {
            const double read = std::max(0.0, first_level(question, known) + 1.5 * std::log2(clip.w));
            pixel[0] = float(bumps_left(read, double(known.flat_level), question.budget));
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
