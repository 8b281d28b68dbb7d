#include "truth.h"

//[solution
#include <cmath>

#include "framework/base/parallel.h"
#include "framework/reference/height_field.h"
//]

namespace relief::budget {

//[solution
namespace {

/// How many pixels a place runs when it moves a metre along the wall's normal, by a difference of two places.
double pixels_of(const Question& question, const glm::dvec3& place) {
    constexpr double step = 1e-4;
    const auto pixel = [&](double z) {
        const glm::dvec4 clip = question.frame.camera.clip_from_world() * glm::dvec4(place.x, place.y, z, 1);
        return glm::dvec2(clip) / clip.w * glm::dvec2(question.frame.size) / 2.0;
    };
    return glm::distance(pixel(step), pixel(-step)) / (2 * step);
}

/// The level, in parts, at which the errors' polygon reaches `most`.
double level_at(const std::vector<float>& errors, double most) {
    for (size_t k = errors.size(); k-- > 0;) {
        const double here = double(errors[k]);
        if (here > most) continue;
        if (k + 1 == errors.size()) return double(k);
        return double(k) + (most - here) / (double(errors[k + 1]) - here);
    }
    return 0;
}

}  // namespace
//]

std::optional<Image> truth(const Probe& probe, const Question& question, const Known& known, const Image& heights) {
    //[solution
    const bool uv = probe.name == "uv", pixels = probe.name == "pixels", left = probe.name == "left";
    const bool level = probe.name == "level", bumps = probe.name == "bumps";
    if (!uv && !pixels && !left && !level && !bumps) return {};
    const HeightField field(heights, true);
    const glm::dvec2 size(field.size());
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
        const double metre = pixels_of(question, front), ahead =
            (question.frame.camera.clip_from_world() * glm::dvec4(front, 1)).w;
        const double tolerated = question.scale > 0 ? question.budget / (metre * question.scale) : 1e30;
        const double low = double(known.range.x), high = double(known.range.y);
        const double cut = std::min(question.thinning * tolerated, (high - low) / 2);
        if (pixels) pixel[0] = float(metre * question.scale);
        if (left) pixel[0] = float(low + cut), pixel[1] = float(high - cut);
        if (level) pixel[0] = float(level_at(known.levels, question.precision * tolerated));
        if (bumps) {
            const double read = std::max(0.0, first_level(question, known) + 1.5 * std::log2(ahead));
            pixel[0] = float(std::clamp(double(known.flat_level) - read - std::log2(question.budget), 0.0, 1.0));
        }
    };
    parallel_pieces(size_t(image.height), 1, 0, [&](size_t begin, size_t end) {
        for (size_t y = begin; y < end; ++y)
            for (int x = 0; x < image.width; ++x) draw(x, int(y));
    });
    return image;
    //]starter
    //| static_cast<void>(probe), static_cast<void>(question), static_cast<void>(known), static_cast<void>(heights);
    //| return {};
    //]
}

}  // namespace relief::budget
