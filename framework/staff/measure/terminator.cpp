// The bump terminator: the mean light of a relief by factors on a normal map's light, against the relief with its own
// shadow. Error by slope and by the light's elevation.
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>

#include "framework/staff/measure/topics.h"
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

using Factor = double (*)(const glm::dvec3& surface, const glm::dvec3& mapped, const glm::dvec3& to_light);

struct Way {
    const char* name;
    double TileLight::*light;
    Factor factor;  ///< on the light of the mapped normal; null for the other two
};
constexpr Way ways[] = {
    {"usual", &TileLight::clamped, [](const glm::dvec3&, const glm::dvec3&, const glm::dvec3&) { return 1.0; }},
    {"estevez", &TileLight::estevez, estevez_shadow},
    {"chiang", &TileLight::chiang, chiang_shadow},
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
            const double facing = std::max(glm::dot(normal, to_light), 0.0);
            if (way.factor)
                sum += facing * way.factor(up, normal, to_light);
            else if (facing > 0 && tile.heights.is_lit(texel, in_heights))
                sum += facing;
        }
    return sum;
}

std::vector<BenchScene> scenes(const BenchSettings& settings) {
    const auto tile = std::make_shared<Tile>(128);
    const int samples = settings.quick ? 64 : 192;
    std::vector<BenchScene> all;
    for (const char* slope : {"0.5", "1", "2"})
        for (const char* elevation : {"5", "10", "20", "30"}) {
            if (settings.quick && slope != std::string("1")) continue;
            BenchScene scene{{{"slope", slope}, {"elevation", elevation}}, "place"};
            const auto lights = std::make_shared<std::vector<TileLight>>();  // by azimuth; the first method fills it
            for (const Way& way : ways)
                scene.methods.push_back(
                    {way.name,
                     {},
                     [=] {
                         const double depth = std::stod(slope) / tile->steepest,
                                      up = glm::radians(std::stod(elevation));
                         const auto light_from = [&](int i) {
                             const double around = glm::two_pi<double>() * (i + 0.3) / 8;
                             return glm::dvec3(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                                               std::sin(up));
                         };
                         // The mean over eight azimuths, in percent of the exact one.
                         double light = 0, exact = 0, largest = 0;
                         if (lights->empty())
                             for (int i = 0; i < 8; ++i)
                                 lights->push_back(tile_light(tile->heights, depth, light_from(i), samples));
                         for (const TileLight& of : *lights) {
                             light += of.*way.light, exact += of.exact;
                             largest = std::max(largest, 100 * std::abs(of.*way.light / of.exact - 1));
                         }
                         const double off = 100 * std::abs(light / exact - 1);
                         const auto sum = std::make_shared<double>(0);
                         const glm::dvec3 to_light = light_from(0);
                         return BenchSubject{
                             .items = size_t(samples) * size_t(samples),
                             .error = {.mean = off, .p99 = largest, .largest = largest, .unit = "percent"},
                             .run = [=] { *sum += summed(way, *tile, depth, to_light, samples); }};
                     },
                     way.light != &TileLight::exact && way.light != &TileLight::estevez});
            all.push_back(scene);
        }
    return all;
}

}  // namespace

BenchTopic terminator_topic() {
    return {"terminator", "light of a normal map under a low lamp, against the relief with its own shadow",
            "How much light does a normal map invent?", scenes};
}

}  // namespace relief::measure
