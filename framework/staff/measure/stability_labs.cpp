// Labs under increasingly hard conditions. Displacement by segments, by pixels, and far from the world's origin. The
// planet from near the ground, the sea after years, shadows of a low sun. Baked maps of decreasing size, and a skin
// under increasing bends.
#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>

#include "framework/core/base/error.h"
#include "framework/course/manifest/manifest.h"
#include "framework/staff/measure/drawn_subject.h"
#include "framework/staff/measure/stability.h"

namespace relief::measure {
namespace {

/// Returns the mean error of a shot's probe. The exact values are for `shot`. The method draws `seen` if it is given.
BenchSweep::Place place_of(const char* number, const Shot& shot, ErrorMetric metric, double hardness,
                           const std::optional<Shot>& seen = {}) {
    const std::shared_ptr<Lab> lab = make_lab(find_lab(number), shot);
    const Image truth = truth_of(*lab, shot);
    const Image errors = error_image(draw_shot(*lab, seen.value_or(shot)), truth, metric);
    Tally tally;
    for (const float error : errors.values)
        if (error != no_surface) tally.add(double(error));
    return tally.mean(hardness);
}

/// A method, given by knobs.
struct Way {
    const char* name;
    BenchKnobs set;
    double stated;
    const char* why;
    bool peer = false;
};

using ShotAt = std::function<Shot(double hardness)>;

BenchScene lab_scene(const char* number, const std::string& input, const std::string& axis, const std::string& unit,
                     ErrorMetric metric, const std::vector<double>& hardness, const std::vector<Way>& ways,
                     const ShotAt& shot_at) {
    std::vector<SweptMethod> methods;
    for (const Way& way : ways)
        methods.push_back({way.name, way.stated, way.why,
                           [=](double hard) {
                               Shot shot = shot_at(hard);
                               shot.set = together(shot.set, way.set);
                               return place_of(number, shot, metric, hard);
                           },
                           way.peer});
    return sweep_scene(input, axis, unit, hardness, methods);
}

std::vector<double> some_of(const std::vector<double>& values, const BenchSettings& settings) {
    if (!settings.quick) return values;
    std::vector<double> some;
    for (size_t i = 0; i < values.size(); i += 2) some.push_back(values[i]);
    return some;
}

BenchScene displacement(const BenchSettings& settings, bool by_patches) {
    const ShotAt shot = [=](double hard) {
        Shot seen;
        seen.size = {96, 96}, seen.probe = {"depth"};
        seen.camera = {.yaw = 30, .pitch = 20, .distance = 2.2};
        // The easiest case has 256 segments along a side of the wall.
        const int segments = int(std::lround(256 / hard));
        const int patches = by_patches ? std::max(1, segments / 16) : 4;
        seen.set = {{"view", "one"},
                    {"surface", "wall"},
                    {"map", "smooth"},
                    {"size", "256"},
                    {"patches", std::to_string(patches)},
                    {"level", std::to_string(std::max(1, segments / patches))}};
        return seen;
    };
    constexpr const char* why = "A chord leaves an arc by the square of its length.";
    return lab_scene(
        "13", by_patches ? "displacement-patches" : "displacement-level",
        by_patches ? "texels a segment, by ever fewer patches of level 16" : "texels a segment, by the level", "metre",
        ErrorMetric::absolute, some_of({1, 2, 4, 8, 16, 32, 64}, settings),
        {{"equal", {{"spacing", "equal"}, {"mip", "base"}}, 0.01, why},
         {"fractional-odd", {{"spacing", "fractional-odd"}, {"mip", "base"}}, 0.01, why},
         {"fractional-even", {{"spacing", "fractional-even"}, {"mip", "base"}}, 0.01, why},
         {"equal-level-by-segment",
          {{"spacing", "equal"}, {"mip", "level"}},
          0.01,
          "A chord leaves an arc by the square of its length; heights read from a smaller level are flatter."}},
        shot);
}

/// A displaced ground seen from 3 metres, at a distance from the world's origin. Measures the error of each vertex in
/// pixels of a picture of 1000 pixels. Uses float arithmetic, like a vertex shader.
BenchScene far_displacement(const BenchSettings& settings) {
    using Project = std::function<glm::vec4(const Camera&, const glm::dvec3& origin, const glm::vec3& vertex)>;
    const Project ours = [](const Camera& camera, const glm::dvec3& origin, const glm::vec3& vertex) {
        return glm::mat4(camera.clip_from_world() * glm::translate(glm::dmat4(1), origin)) * glm::vec4(vertex, 1);
    };
    const Project usual = [](const Camera& camera, const glm::dvec3& origin, const glm::vec3& vertex) {
        const glm::vec4 world = glm::translate(glm::mat4(1), glm::vec3(origin)) * glm::vec4(vertex, 1);
        return glm::mat4(camera.clip_from_world()) * world;
    };
    std::vector<SweptMethod> methods;
    for (const auto& [name, why, project, peer] :
         {std::tuple{"clip-from-model",
                     "The matrices are multiplied in double: what is rounded is as small as the model.", ours, false},
          {"world-in-floats", "A float of 100 km has steps of 8 mm: vertices jump from one to the next.", usual, true}})
        methods.push_back(
            {name, 0.01, why,
             [project = project](double hard) {
                 const glm::dvec3 origin = hard * glm::normalize(glm::dvec3(3, 1, 2));
                 const Camera camera({.yaw = 30, .pitch = 25, .distance = 3, .target = origin}, 1);
                 Tally tally;
                 constexpr int side = 33;
                 for (int i = 0; i < side * side; ++i) {
                     const double x = 2.0 * (i % side) / (side - 1) - 1, z = 2.0 * (i / side) / (side - 1) - 1;
                     const glm::vec3 vertex(x, 0.1 * std::sin(9 * x) * std::cos(7 * z), z);
                     const glm::dvec4 exact = camera.clip_from_world() * glm::dvec4(origin + glm::dvec3(vertex), 1);
                     const glm::dvec4 drawn(project(camera, origin, vertex));
                     tally.add(500 * glm::length(glm::dvec2(drawn) / drawn.w - glm::dvec2(exact) / exact.w));
                 }
                 return tally.largest(hard);
             },
             peer});
    return sweep_scene("displacement-far", "metres from the world's origin", "pixel",
                       some_of(decades(0, 8, 0.5), settings), methods);
}

/// Lab 14's levels: the 99th percentile of the screen error of a ground, in units of the tolerated error.
BenchScene adaptive_displacement(const BenchSettings& settings) {
    std::vector<SweptMethod> methods;
    for (const auto& [name, knobs, why, peer] :
         {std::tuple{"by-error", BenchKnobs{{"method", "error"}}, "Levels follow the error on the screen.", false},
          {"by-size", BenchKnobs{{"method", "size"}, {"segment", "8"}},
           "Eight pixels a segment: too many where the ground is flat, too few where it is steep.", true}})
        methods.push_back({name, 1, why,
                           [knobs = knobs](double hard) {
                               Tally tally;
                               for (const double pixels :
                                    ground_pixels_off(together(knobs, {{"budget", fmt::format("{}", 1 / hard)}})))
                                   tally.add(pixels * hard);
                               return tally.most(hard);
                           },
                           peer});
    return sweep_scene("displacement-budget", "1 / tolerated error, 1 / pixels", "budget",
                       some_of({0.125, 0.25, 0.5, 1, 2, 4, 8}, settings), methods);
}

/// Positions shown by pixels, relative to their distance: 0.001 is one pixel of a picture of 1000 pixels.
BenchScene planet(const BenchSettings& settings) {
    std::vector<SweptMethod> methods;
    for (const auto& [name, why, peer] :
         {std::tuple{"camera-relative", "The eye is subtracted in double: what is rounded is as small as it is near.",
                     false},
          {"float", "A float of 6,371,000 metres has steps of half a metre: near by they are large.", true}})
        methods.push_back({name, 1e-3, why,
                           [precise = std::string(name)](double hard) {
                               Shot shot;
                               shot.size = {48, 48}, shot.probe = {"place"};
                               shot.camera = load_manifest(find_lab("09")).camera;
                               shot.set = {{"view", "planet"},
                                           {"eye", "ground"},
                                           {"tilt", "-80"},
                                           {"radius", "6.804"},
                                           {"levels", "error"},
                                           {"budget", "0.25"},
                                           {"altitude", fmt::format("{}", -std::log10(hard))},
                                           {"precise", precise}};
                               const std::shared_ptr<Lab> lab = make_lab(find_lab("09"), shot);
                               const Image truth = truth_of(*lab, shot);
                               const Image errors = error_image(draw_shot(*lab, shot), truth, ErrorMetric::distance);
                               Tally tally;
                               for (size_t i = 0; i < errors.values.size(); ++i) {
                                   const float* const place = &truth.values[4 * i];
                                   if (errors.values[i] != no_surface)
                                       tally.add(double(errors.values[i]) /
                                                 glm::length(glm::dvec3(place[0], place[1], place[2])));
                               }
                               return tally.mean(hard);
                           },
                           peer});
    return sweep_scene("planet-near", "radius of an Earth by the eye's height above ground", "share of the distance",
                       some_of(decades(0.5, 6, 0.5), settings), methods);
}

BenchScene sea(const BenchSettings& settings) {
    const auto shot_at = [](double hard) {
        Shot seen;
        seen.size = {64, 64}, seen.probe = {"normal"}, seen.time = hard + 1.0 / 3;
        seen.camera = {.yaw = 180, .pitch = 60, .distance = 20, .target = {0, 0, 0}};
        seen.set = {{"view", "one"}, {"displace", "false"}, {"level", "0"}};
        return seen;
    };
    std::vector<SweptMethod> methods;
    methods.push_back({"whole-tiles-dropped", 0.5,
                       "A double knows a time of 30 years to a hundred-millionth of a second.",
                       [=](double hard) { return place_of("15", shot_at(hard), ErrorMetric::angle, hard); }});
    methods.push_back({"seconds-in-a-float", 0.5,
                       "Steps of a sixteenth of a second after 12 days, of 64 seconds after 30 years.",
                       [=](double hard) {
                           Shot seen = shot_at(hard);
                           seen.time = double(float(seen.time));
                           return place_of("15", shot_at(hard), ErrorMetric::angle, hard, seen);
                       },
                       true});
    return sweep_scene("sea-time", "seconds since the start", "degree", some_of(decades(0, 9, 1), settings), methods);
}

double pitch_of(double hard) { return glm::degrees(std::asin(1 / hard)); }

/// Returns 1 / sine of the sun's elevation, for elevations from 64 down to 1 degree.
std::vector<double> low_suns(const BenchSettings& settings) {
    std::vector<double> all;
    for (const double degrees : {64, 45, 30, 20, 12, 7, 4, 2, 1}) all.push_back(1 / std::sin(glm::radians(degrees)));
    return some_of(all, settings);
}

BenchScene shadow_map(const BenchSettings& settings) {
    return lab_scene(
        "16", "shadow-map", "1 / sine of the sun's elevation (57: 1 degree)", "share", ErrorMetric::absolute,
        low_suns(settings),
        {{"plane", {{"bias", "plane"}}, 0.1, "The bias follows the plane, however low the sun stands."},
         {"constant", {{"bias", "constant"}}, 0.1, "One texel is too little for ground that the sun grazes.", true},
         {"none", {{"bias", "none"}}, 0.1, "The ground shades itself.", true}},
        [](double hard) {
            Shot seen;
            seen.size = {96, 96}, seen.probe = {"shadow"};
            seen.camera = load_manifest(find_lab("16")).camera;
            seen.set = {{"displace", "false"}, {"light_pitch", fmt::format("{:.6f}", pitch_of(hard))}};
            return seen;
        });
}

BenchScene relief_shadow(const BenchSettings& settings) {
    constexpr const char* why = "The shadow's ray is the search's own, from a little above the relief.";
    return lab_scene("12", "relief-shadow", "1 / sine of the sun's elevation (57: 1 degree)", "share",
                     ErrorMetric::absolute, low_suns(settings),
                     {{"windows", {{"method", "windows"}}, 0.01, why}, {"walk", {{"method", "walk"}}, 0.01, why}},
                     [](double hard) {
                         Shot seen;
                         seen.size = {64, 64}, seen.probe = {"shadow"};
                         seen.camera = {.yaw = 25, .pitch = 20, .distance = 1.2};
                         // The wall stands upright: a light at the horizon grazes it from the side.
                         seen.set = {{"view", "one"},    {"map", "stones"},
                                     {"size", "256"},    {"light_pitch", "0"},
                                     {"shadow", "hard"}, {"light_yaw", fmt::format("{:.6f}", 90 - pitch_of(hard))}};
                         return seen;
                     });
}

BenchScene baking(const BenchSettings& settings) {
    std::vector<double> hardness = {1, 2, 4, 8, 16};
    if (settings.quick) hardness = {2, 4, 8};
    return lab_scene(
        "07", "baked-map", "1024 / side of the map", "degree", ErrorMetric::angle, hardness,
        {{"one-frame", {}, 0.35, "A texel is the mean of what it covers."},
         {"object-space", {{"map", "object"}}, 0.35, "A texel is the mean of what it covers."},
         {"two-frames",
          {{"frame", "gram-schmidt"}},
          0.35,
          "Baked in one frame and read in another: no map is fine enough.",
          true}},
        [](double hard) {
            Shot seen;
            seen.size = {160, 160}, seen.probe = {"normal"};
            seen.camera = load_manifest(find_lab("07")).camera;
            seen.set = {
                {"view", "one"}, {"high", "16k"}, {"level", "0"}, {"map_size", std::to_string(int(1024 / hard))}};
            return seen;
        });
}

BenchScene skin(const BenchSettings& settings) {
    constexpr const char* gradient =
        "The gradient of the weights is part of the frame, also where the skin folds, beyond 106 degrees.";
    constexpr const char* without = "The gradient of the weights is missing: nothing says that the skin stretches.";
    return lab_scene(
        "18", "skin-bend", "bend of the joint, degrees", "degree", ErrorMetric::angle,
        some_of({1, 3, 10, 20, 30, 45, 60, 75, 90, 105, 120, 135, 150}, settings),
        {{"gradient", {{"normal_by", "gradient"}}, 0.1, gradient},
         {"dual-gradient", {{"normal_by", "gradient"}, {"blend", "dual-quaternion"}}, 0.1, gradient},
         {"matrix", {{"normal_by", "matrix"}}, 0.1, without, true},
         {"inverse-transpose", {{"normal_by", "inverse-transpose"}}, 0.1, without, true},
         {"unit-cofactors", {{"normal_by", "unit-cofactors"}}, 0.1, without, true},
         {"dual-rotation", {{"normal_by", "matrix"}, {"blend", "dual-quaternion"}}, 0.1, without, true}},
        [](double hard) {
            Shot seen;
            seen.size = {48, 96}, seen.probe = {"normal"};
            seen.set = {{"view", "skin"}, {"shape", "tube"}, {"relief", "0"}, {"bend", fmt::format("{}", hard)}};
            return seen;
        });
}

}  // namespace

std::vector<BenchScene> lab_sweeps(const BenchSettings& settings) {
    return {displacement(settings, false),
            displacement(settings, true),
            far_displacement(settings),
            adaptive_displacement(settings),
            planet(settings),
            sea(settings),
            shadow_map(settings),
            relief_shadow(settings),
            baking(settings),
            skin(settings)};
}

}  // namespace relief::measure
