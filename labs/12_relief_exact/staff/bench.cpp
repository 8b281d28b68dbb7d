// The bump terminator: the light of a relief by factors on a normal map's light, against the relief with its own
// shadow. Error of the mean and by place, by slope and by the light's elevation.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>

#include "framework/staff/measure/bench.h"
#include "framework/staff/reference/terminator.h"

namespace relief::measure {
namespace {

/// A relief, and its steepest slope for a depth of 1 texel.
struct Tile {
    HeightField heights;
    double steepest = 0;
    explicit Tile(int side) : heights(sine_relief(side), true) {
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                steepest = std::max(steepest, glm::length(heights.slope(glm::dvec2(x, y) + 0.7)));
    }
};

using Light = double (*)(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light);
using Unit = const glm::dvec3&;

double facing(Unit mapped, Unit to_light) { return std::max(glm::dot(mapped, to_light), 0.0); }

struct Way {
    const char* name;
    double TileLight::*light;
    Light of_normal;  ///< null for the other two
};
constexpr Way ways[] = {
    {"usual", &TileLight::clamped, [](Unit, Unit mapped, Unit light) { return facing(mapped, light); }},
    {"estevez", &TileLight::estevez,
     [](Unit surface, Unit mapped, Unit light) {
         return facing(mapped, light) * estevez_shadow(surface, mapped, light);
     }},
    {"chiang", &TileLight::chiang,
     [](Unit surface, Unit mapped, Unit light) {
         return facing(mapped, light) * chiang_shadow(surface, mapped, light);
     }},
    {"schuessler", &TileLight::schuessler,
     [](Unit surface, Unit mapped, Unit light) { return schuessler_light(surface, mapped, light).sum(); }},
    {"no-map", &TileLight::flat, nullptr},
    {"shadow", &TileLight::exact, nullptr}};

/// Returns the light of a tile, summed over its places: the work of a pixel without its texture.
double summed(const Way& way, const Tile& tile, double depth, const glm::dvec3& to_light, int samples) {
    const bool is_flat = way.light == &TileLight::flat;
    const glm::dvec3 up(0, 0, 1), in_heights(to_light.x, to_light.y, to_light.z / depth);
    double sum = 0;
    for (int row = 0; row < samples; ++row)
        for (int column = 0; column < samples; ++column) {
            if (is_flat) {
                sum += to_light.z;
                continue;
            }
            const glm::dvec2 texel =
                (glm::dvec2(column, row) + 0.5) / double(samples) * glm::dvec2(tile.heights.size());
            const glm::dvec3 normal = glm::normalize(glm::dvec3(-depth * tile.heights.slope(texel), 1));
            if (way.of_normal)
                sum += way.of_normal(up, normal, to_light);
            else if (glm::dot(normal, to_light) > 0 && tile.heights.is_lit(texel, in_heights))
                sum += facing(normal, to_light);
        }
    return sum;
}

using Lights = std::vector<std::vector<TileLight>>;  ///< by azimuth, then by place

/// Returns the error of the mean light over eight azimuths, in percent of the exact one. The other figures are the
/// largest error of an azimuth's mean.
BenchError error_of_mean(const Way& way, const Lights& lights) {
    double light = 0, exact = 0, largest = 0;
    for (const std::vector<TileLight>& places : lights) {
        double light_here = 0, exact_here = 0;
        for (const TileLight& place : places) light_here += place.*way.light, exact_here += place.exact;
        light += light_here, exact += exact_here;
        largest = std::max(largest, 100 * std::abs(light_here / exact_here - 1));
    }
    return {.mean = 100 * std::abs(light / exact - 1), .p99 = largest, .largest = largest, .unit = "percent"};
}

/// Returns the errors of the places, in percent of the mean exact light. `mean` is the root mean square, in which light
/// at one place does not make up for its lack at another.
BenchError error_by_place(const Way& way, const Lights& lights) {
    double squares = 0, exact = 0;
    std::vector<double> errors;
    for (const std::vector<TileLight>& places : lights)
        for (const TileLight& place : places) {
            errors.push_back(std::abs(place.*way.light - place.exact));
            squares += errors.back() * errors.back();
            exact += place.exact;
        }
    const double count = double(errors.size()), percent = 100 * count / exact;
    for (double& error : errors) error *= percent;
    BenchError figures = error_figures(std::move(errors), "percent");
    figures.mean = percent * std::sqrt(squares / count);
    return figures;
}

BenchScene scene_of(const std::shared_ptr<Tile>& tile, const std::string& slope, const std::string& elevation,
                    bool by_place, int samples) {
    BenchScene scene{{{"slope", slope}, {"elevation", elevation}}, "place"};
    if (by_place) scene.knobs.emplace_back("error", "by-place");
    const auto lights = std::make_shared<Lights>();  // the first method fills it
    for (const Way& way : ways)
        scene.methods.push_back(
            {way.name,
             {},
             [=] {
                 const double depth = std::stod(slope) / tile->steepest, up = glm::radians(std::stod(elevation));
                 const auto light_from = [&](int i) {
                     const double around = glm::two_pi<double>() * (i + 0.3) / 8;
                     return glm::dvec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around), std::sin(up));
                 };
                 if (lights->empty())
                     for (int i = 0; i < 8; ++i)
                         lights->push_back(place_lights(tile->heights, depth, light_from(i), samples));
                 const auto sum = std::make_shared<double>(0);
                 const glm::dvec3 to_light = light_from(0);
                 return BenchSubject{.items = size_t(samples) * size_t(samples),
                                     .error = by_place ? error_by_place(way, *lights) : error_of_mean(way, *lights),
                                     .run = [=] { *sum += summed(way, *tile, depth, to_light, samples); }};
             },
             way.light != &TileLight::exact && way.light != &TileLight::estevez});
    return scene;
}

std::vector<BenchScene> terminator_scenes(const BenchSettings& settings) {
    const auto tile = std::make_shared<Tile>(128);
    const int samples = settings.quick ? 64 : 192;
    std::vector<BenchScene> all;
    for (const bool by_place : {false, true})
        for (const char* slope : {"0.5", "1", "2"})
            for (const char* elevation : {"5", "10", "20", "30"})
                if (!settings.quick || slope == std::string("1"))
                    all.push_back(scene_of(tile, slope, elevation, by_place, samples));
    return all;
}

}  // namespace

const TopicRegistration terminator_topic(
    {.name = "terminator",
     .help = "light of a normal map under a low lamp, against the relief with its own shadow",
     .question = "How much light does a normal map invent?",
     .scenes = terminator_scenes,
     .labs = {"12"}});

}  // namespace relief::measure
