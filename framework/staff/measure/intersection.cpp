// The exact first hit of a ray and a height map, by view angle: the cost of the parallax labs' exact values.
#include <cmath>
#include <memory>
#include <random>

#include "framework/height/maps.h"
#include "framework/staff/measure/topics.h"
#include "framework/staff/reference/height_field.h"

namespace relief {
namespace {

std::vector<BenchScene> scenes(const BenchSettings& settings) {
    const size_t count = settings.quick ? 20'000 : 250'000;
    BenchScene scene{{}, "ray"};
    for (const int degrees : {30, 60, 75, 85})
        scene.methods.push_back(
            {"cell-walk", {{"angle", std::to_string(degrees)}}, [=] {
                 constexpr double depth = 20;  // texels
                 const auto field = std::make_shared<HeightField>(make_height_map(HeightMap::fbm, 256), true);
                 std::mt19937 random(2);
                 std::uniform_real_distribution<> share(0, 1);
                 const double reach = depth * std::tan(degrees * M_PI / 180);
                 std::vector<Ray> rays;
                 for (size_t i = 0; i < count; ++i) {
                     const double turn = 2 * M_PI * share(random);
                     rays.push_back({{256 * share(random), 256 * share(random), 1},
                                     {reach * std::cos(turn), reach * std::sin(turn), -1}});
                 }
                 // The hit lies on the surface and on the ray: how far apart the two are there, in texels of depth.
                 std::vector<double> errors;
                 for (const Ray& ray : rays)
                     if (const auto hit = field->first_hit(ray, 1))
                         errors.push_back(depth * std::abs(ray.at(hit->t).z - field->height(hit->texel)));
                 return BenchSubject{.items = count,
                                     .error = error_figures(std::move(errors), "texel"),
                                     .run = [field, rays = std::move(rays), sum = 0.0]() mutable {
                                         for (const Ray& ray : rays)
                                             if (const auto hit = field->first_hit(ray, 1)) sum += hit->t;
                                     }};
             }});
    return {scene};
}

}  // namespace

BenchTopic intersection_topic() {
    return {"intersection", "the exact first hit in a 256² map, 20 texels deep, by degrees from the normal", scenes};
}

}  // namespace relief
