// The exact first hit of a ray and a height map, by view angle: the cost of the parallax labs' exact values. Also the
// first hit of a ray and a mesh: the cost of a bake.
#include <cmath>
#include <memory>
#include <random>

#include "framework/library/maps/test_maps.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/edge_rays.h"
#include "framework/staff/measure/peers.h"
#include "framework/staff/reference/height_field.h"
#include "framework/staff/reference/mesh_rays.h"

namespace relief::measure {
namespace {

BenchScene mesh_scene(const BenchSettings& settings) {
    const auto work = [quick = settings.quick] {
        return std::make_shared<const RaysThroughEdges>(quick ? 32 : 104, quick ? 20'000 : 250'000);
    };
    BenchScene scene{{{"rays", "through-edges"}}, "ray"};
    scene.methods.push_back({"double", {}, [work] {
                                 const auto rays = work();
                                 std::vector<double> hits;
                                 const auto search = [rays, tree = build_tree(rays->mesh)](std::vector<double>& found) {
                                     found.clear();
                                     for (const Ray& ray : rays->rays) {
                                         const auto hit = first_hit(tree, rays->mesh, ray, 2);
                                         found.push_back(hit ? hit->t : -1);
                                     }
                                 };
                                 search(hits);
                                 return BenchSubject{.items = hits.size(),
                                                     .error = rays->error_of(hits),
                                                     .run = [search, hits]() mutable { search(hits); }};
                             }});
    for (const bool robust : {true, false})
        if (has_peers())
            scene.methods.push_back(
                {"Embree",
                 {{"robust", robust ? "on" : "off"}},
                 [work, robust] {
                     const auto rays = work();
                     const std::shared_ptr peer = embree_hits(rays->mesh, robust, false);
                     std::vector<double> hits;
                     embree_hits(rays->mesh, robust, true)->run(rays->rays, hits);  // its errors are in the baseline
                     return BenchSubject{.items = hits.size(), .error = rays->error_of(hits), .run = [=]() mutable {
                                             peer->run(rays->rays, hits);
                                         }};
                 },
                 true});
    return scene;
}

std::vector<BenchScene> intersection_scenes(const BenchSettings& settings) {
    const size_t count = settings.quick ? 20'000 : 250'000;
    BenchScene scene{{}, "ray"};
    for (const int degrees : {30, 60, 75, 85})
        scene.methods.push_back(
            {"cell-walk", {{"angle", std::to_string(degrees)}}, [=] {
                 constexpr double depth = 20;  // in texels
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
                 // The exact hit lies on the surface and on the ray. The error is the vertical distance of both there,
                 // in texels.
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
    return {scene, mesh_scene(settings)};
}

}  // namespace

const TopicRegistration intersection_topic(
    {"intersection",
     "the exact first hit in a 256² map, 20 texels deep, by degrees from the normal; and in a mesh of 129,792 "
     "triangles",
     "How long does an exact hit take, and what is given away by a quicker one?", intersection_scenes});

}  // namespace relief::measure
