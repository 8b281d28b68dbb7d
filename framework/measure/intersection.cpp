// The exact first hit of a ray and a height map, by view angle: what the truth of the parallax labs costs.
#include <cmath>
#include <memory>
#include <random>

#include "framework/image/height_maps.h"
#include "framework/measure/topics.h"
#include "framework/reference/height_field.h"

namespace relief {
namespace {

struct Work {
    HeightField field;
    std::vector<std::vector<Ray>> rays;  // by angle
    double sum = 0;                      // so that the hits are used
};

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    const size_t count = settings.quick ? 20'000 : 250'000;
    constexpr double depth = 20;  // texels
    const auto work = std::make_shared<Work>(Work{HeightField(make_height_map(HeightMap::fbm, 256), true), {}, 0});
    std::mt19937 random(2);
    std::uniform_real_distribution<> share(0, 1);
    std::vector<BenchMethod> result;
    for (const int degrees : {30, 60, 75, 85}) {
        std::vector<Ray>& rays = work->rays.emplace_back();
        const double reach = depth * std::tan(degrees * M_PI / 180);
        for (size_t i = 0; i < count; ++i) {
            const double turn = 2 * M_PI * share(random);
            rays.push_back(
                {{256 * share(random), 256 * share(random), 1}, {reach * std::cos(turn), reach * std::sin(turn), -1}});
        }
        // The hit lies on the surface and on the ray: how far apart the two are there, in texels of depth.
        std::vector<double> errors;
        for (const Ray& ray : rays)
            if (const auto hit = work->field.first_hit(ray, 1))
                errors.push_back(depth * std::abs(ray.at(hit->t).z - work->field.height(hit->texel)));
        result.push_back({.name = "cell-walk",
                          .knobs = {{"angle", std::to_string(degrees)}},
                          .items = count,
                          .item = "ray",
                          .run =
                              [work, i = work->rays.size() - 1] {
                                  for (const Ray& ray : work->rays[i])
                                      if (const auto hit = work->field.first_hit(ray, 1)) work->sum += hit->t;
                              },
                          .error = error_figures(std::move(errors), "texel")});
    }
    return result;
}

}  // namespace

BenchTopic intersection_topic() {
    return {"intersection", "the exact first hit in a 256² map, 20 texels deep, by degrees from the normal", methods};
}

}  // namespace relief
