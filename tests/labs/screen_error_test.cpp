// Measures the error of lab 14 in pixels over a camera path, and whether its culling changes the picture.
#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>
#include <numeric>
#include <optional>

#include "framework/library/kit/displaced_surface.h"
#include "framework/library/maps/test_maps.h"
#include "framework/staff/measure/drawn_subject.h"
#include "framework/staff/reference/patch_points.h"
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr glm::ivec2 picture_size{64, 48};
constexpr int frames = 200;

/// Returns the camera of a frame. The path circles the ground once, from close above it to far away.
Orbit camera_at(int frame) {
    const double share = double(frame) / frames;
    return {.yaw = 360 * share,
            .pitch = 18 + 14 * std::sin(glm::two_pi<double>() * 3 * share),
            .distance = 5.5 + 3.5 * std::sin(glm::two_pi<double>() * 2 * share),
            .target = {2 * std::cos(glm::two_pi<double>() * share), 0, 2 * std::sin(glm::two_pi<double>() * share)},
            .field_of_view = 40};
}

Image probed(Lab& lab, const char* name, int frame) {
    const Target target(TargetKind::probe, picture_size);
    draw_lab(lab, frame_of({.size = picture_size, .time = 0, .camera = camera_at(frame), .probe = {name}, .set = {}},
                           target));
    return target.read();
}

/// Lab 14's ground: 16 m wide, under one tile of `map`, 1.6 m deep.
struct Ground {
    std::string map;
    std::unique_ptr<Lab> lab;

    Ground(const char* map_name, std::vector<Knob> more) : map(map_name) {
        std::vector<Knob> knobs = {{"view", "eye"}, {"surface", "ground"}, {"corners", "4"}, {"patches", "32"},
                                   {"map", map},    {"size", "512"},       {"depth", "0.1"}, {"repeat", "1"}};
        knobs.insert(knobs.end(), more.begin(), more.end());
        lab = make_lab(find_lab("14"), shot_of("14", knobs));
    }

    /// Returns the errors of every `step`th frame in pixels, sorted. An error is the distance on the screen between a
    /// pixel and the exact position of the surface point that it shows, on the bilinear displaced surface.
    std::vector<double> screen_errors(int step) const {
        DisplacedSurface surface;
        surface.shape = DisplacedSurface::ground, surface.density = 32, surface.material.size = 2, surface.depth = 0.1f;
        surface.material.map =
            int(std::find(height_map_names.begin(), height_map_names.end(), map) - height_map_names.begin());
        const HeightField heights(surface.heights(), true);
        std::vector<double> errors;
        for (int frame = 0; frame < frames; frame += step) {
            const Image place = probed(*lab, "place", frame);
            const glm::dmat4 clip_from_world =
                Camera(camera_at(frame), double(picture_size.x) / picture_size.y).clip_from_world();
            const auto more =
                relief::screen_errors(place, surface.patches(), heights, double(surface.scale()), clip_from_world);
            errors.insert(errors.end(), more.begin(), more.end());
        }
        std::sort(errors.begin(), errors.end());
        return errors;
    }
};

double quantile_of(const std::vector<double>& sorted, double share) {
    return sorted[size_t(share * double(sorted.size() - 1))];
}

void expect_within_budget(const char* map, const char* budget, int step) {
    const auto errors = Ground(map, {{"method", "error"}, {"budget", budget}}).screen_errors(step);
    EXPECT_GT(errors.size(), size_t(frames / step) * 1000);
    EXPECT_LT(quantile_of(errors, 0.999), 2 * std::atof(budget)) << map << ", budget " << budget;
}

TEST(ScreenError, StaysWithinTwiceTheBudgetFor999OfAThousandPixelsOfThePath) {
    for (const char* budget : {"0.5", "1", "2"}) expect_within_budget("fbm", budget, 1);
}

TEST(ScreenError, StaysWithinTwiceTheBudgetOnOtherMapsWithoutCliffs) {
    for (const char* map : {"smooth", "stones", "rock"})
        for (const char* budget : {"0.5", "2"}) expect_within_budget(map, budget, 20);
    // At half a pixel, the step of one texel in bricks and posts would need a level above 64.
    for (const char* map : {"bricks", "posts"}) expect_within_budget(map, "2", 20);
}

TEST(ScreenError, DetectsALevelThatIsTooLow) {
    const auto errors = Ground("fbm", {{"method", "uniform"}, {"level", "1"}}).screen_errors(20);
    EXPECT_GT(quantile_of(errors, 0.999), 2);
}

/// The triangles of one picture of the ground by one method, and the errors of its pixels, sorted.
struct Cost {
    double triangles;
    std::vector<double> screen;  ///< pixels
    std::vector<double> along;   ///< metres along the ray, where it meets the ground
};

Cost cost_of(const char* map, const Orbit& camera, const char* method, const char* knob, const char* value) {
    Shot shot = shot_of("14",
                        {{"view", "eye"},
                         {"surface", "ground"},
                         {"corners", "4"},
                         {"patches", "36"},
                         {"map", map},
                         {"size", "512"},
                         {"depth", "0.1"},
                         {"repeat", "1"},
                         {"method", method},
                         {knob, value}},
                        "place", {128, 96});
    shot.camera = camera;
    const std::shared_ptr<Lab> lab = make_lab(find_lab("14"), shot);
    DisplacedSurface surface;
    surface.shape = DisplacedSurface::ground, surface.density = 36, surface.material.size = 2, surface.depth = 0.1f;
    surface.material.map =
        int(std::find(height_map_names.begin(), height_map_names.end(), map) - height_map_names.begin());
    const HeightField heights(surface.heights(), true);

    Cost cost{};
    const measure::BenchSubject subject = measure::drawn(lab, shot);
    for (const auto& [name, amount] : subject.work)
        if (name == "triangles") cost.triangles = amount;
    const Frame frame = frame_of(shot, Target(TargetKind::probe, shot.size));
    cost.screen = screen_errors(render_shot(*lab, shot), surface.patches(), heights, double(surface.scale()),
                                frame.camera.clip_from_world());
    shot.probe = {"depth"};
    const Image depth = render_shot(*lab, shot);
    const auto& points = surface.patches().points;
    const glm::dvec3 origin(points[0].vertex.position);
    const glm::dvec2 map_size(heights.size()), texel(glm::dvec2(points[0].vertex.uv) * map_size);
    const double per_metre = map_size.x / DisplacedSurface::ground_metres;
    const double up = points[3].vertex.position.z < points[0].vertex.position.z ? -per_metre : per_metre;
    for (int y = 0; y < depth.height; ++y)
        for (int x = 0; x < depth.width; ++x) {
            const Ray ray = frame.ray(x, y);
            const glm::dvec3 from = ray.origin - origin, scale(per_metre, 1 / double(surface.scale()), up);
            const auto as_texels = [&](glm::dvec3 v) {
                return glm::dvec3(v.x * scale.x, v.z * scale.z, v.y * scale.y);
            };
            if (*depth.pixel(x, y) == no_surface || ray.direction.y >= 0) continue;
            const auto hit = heights.first_hit({as_texels(from) + glm::dvec3(texel, 1), as_texels(ray.direction)}, 1e3);
            if (hit && hit->texel == glm::clamp(hit->texel, glm::dvec2(0), map_size))
                cost.along.push_back(std::abs(hit->t - double(*depth.pixel(x, y))));
        }
    std::sort(cost.screen.begin(), cost.screen.end()), std::sort(cost.along.begin(), cost.along.end());
    return cost;
}

double mean_of(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// Returns the number of triangles that `error` needs per triangle of `size`, at equal error as measured by `figure`.
template <class Figure>
double triangles_by_error_to_size(const char* map, const Orbit& camera, const char* budget, Figure figure) {
    const Cost by_error = cost_of(map, camera, "error", "budget", budget);
    const double wanted = figure(by_error);
    std::optional<Cost> coarser;
    for (const char* segment : {"16", "8", "4", "2", "1"}) {
        Cost finer = cost_of(map, camera, "size", "segment", segment);
        if (figure(finer) <= wanted && coarser) {
            // Both errors fall with a power of the number of triangles.
            const double share = std::log(wanted / figure(*coarser)) / std::log(figure(finer) / figure(*coarser));
            return by_error.triangles / (coarser->triangles * std::pow(finer.triangles / coarser->triangles, share));
        }
        coarser = std::move(finer);
    }
    ADD_FAILURE() << "no size is off by " << wanted;
    return 0;
}

constexpr Orbit from_low{.yaw = 30, .pitch = 7, .distance = 7.5, .target = {0, -0.5, 0}},
    from_above{.yaw = 200, .pitch = 35, .distance = 7, .target = {-1, -0.8, 1}};

TEST(ScreenError, LevelsByErrorNeedFewerTrianglesThanBySizeForTheSame99Percent) {
    const auto figure = [](const Cost& cost) { return quantile_of(cost.screen, 0.99); };
    for (const char* map : {"fbm", "stones", "rock"}) {
        double product = 1;
        for (const Orbit& camera : {from_low, from_above})
            product *= triangles_by_error_to_size(map, camera, "2", figure);
        EXPECT_LT(std::sqrt(product), 0.95) << map;
        EXPECT_GT(product, 0) << map;
    }
}

TEST(ScreenError, LevelsByErrorNeedMoreTrianglesForTheSameMeanRayErrorOnStones) {
    const auto figure = [](const Cost& cost) { return mean_of(cost.along); };
    EXPECT_GT(triangles_by_error_to_size("stones", from_low, "0.5", figure), 2);
}

/// Returns which pixel centres a mesh covers, in double precision.
std::vector<bool> covered(const Mesh& mesh, const Camera& camera, glm::ivec2 pixels) {
    const glm::dmat4 clip_from_world = camera.clip_from_world();
    const auto seen = [&](uint32_t index) {
        const glm::dvec4 clip = clip_from_world * glm::dvec4(mesh.vertices[index].position, 1);
        return (glm::dvec2(clip) / clip.w * glm::dvec2(0.5, -0.5) + 0.5) * glm::dvec2(pixels) - 0.5;
    };
    const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
    std::vector<bool> result(size_t(pixels.x * pixels.y));
    for (size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::dvec2 a = seen(mesh.indices[i]), b = seen(mesh.indices[i + 1]), c = seen(mesh.indices[i + 2]);
        const glm::ivec2 low = glm::max(glm::ivec2(glm::ceil(glm::min(a, glm::min(b, c)))), 0);
        const glm::ivec2 high = glm::min(glm::ivec2(glm::floor(glm::max(a, glm::max(b, c)))), pixels - 1);
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec2 p(x, y);
                const double u = cross(b - a, p - a), v = cross(c - b, p - b), w = cross(a - c, p - c);
                if ((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))
                    result[size_t(y * pixels.x + x)] = true;
            }
    }
    return result;
}

TEST(Outline, ConvergesToMicroPolygonsAsTheLevelRises) {
    const glm::ivec2 pixels(160, 160);
    DisplacedSurface surface;
    surface.shape = DisplacedSurface::torus, surface.density = 4, surface.depth = 0.1f;
    surface.material.map = int(HeightMap::stones), surface.material.size = 1;
    Shot shot = shot_of("13",
                        {{"view", "one"},
                         {"surface", "torus"},
                         {"mip", "base"},
                         {"corners", "4"},
                         {"patches", "4"},
                         {"map", "stones"},
                         {"size", "256"},
                         {"depth", "0.1"}},
                        "place", pixels);
    shot.camera = {.yaw = 35, .pitch = 25, .distance = 3.4};
    const HeightField heights(surface.heights(), true);
    const auto exact = covered(micro_polygons(surface.patches(), heights, double(surface.scale()), 96),
                               Camera(shot.camera, 1), pixels);
    const double all = double(std::count(exact.begin(), exact.end(), true));
    const auto lab = make_lab(find_lab("13"), shot);
    double before = 1;
    for (const auto& [level, max] : {std::pair("4", 0.15), {"16", 0.02}, {"64", 0.004}}) {
        set_knob(*lab, "level", level);
        const Image place = render_shot(*lab, shot);
        double apart = 0;
        for (size_t i = 0; i < exact.size(); ++i) apart += exact[i] != (place.values[i * 4] != no_surface);
        EXPECT_LT(apart / all, max) << "level " << level;
        EXPECT_LT(apart / all, before / 3) << "level " << level;
        before = apart / all;
    }
}

TEST(Culling, ChangesNoPixelOfThePath) {
    const Ground all("fbm", {{"method", "error"}, {"budget", "4"}, {"cull", "none"}});
    const Ground culled("fbm", {{"method", "error"}, {"budget", "4"}, {"cull", "all"}});
    for (int frame = 0; frame < frames; ++frame) {
        EXPECT_EQ(probed(*all.lab, "depth", frame).values, probed(*culled.lab, "depth", frame).values)
            << "frame " << frame;
        if (HasFailure()) return;
    }
}

}  // namespace
}  // namespace relief
