// Normals from heights: by slope, and by the quantisation of the heights.
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/staff/measure/peers.h"
#include "framework/staff/measure/stability.h"
#include "framework/staff/measure/usual.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/normals.h"

namespace relief::measure {
namespace {

constexpr int map_side = 32, border = 4;  // border texels are excluded: filters differ there by design

constexpr double ramp_u = 0.625, ramp_v = 0.75;  // dh/du and dh/dv of a ramp of slope 1

/// A ramp whose steps floats hold exactly: all filters should find its slope. Rows run down, v up.
Image ramp() {
    Image heights(map_side, map_side, 1);
    for (int y = 0; y < map_side; ++y)
        for (int x = 0; x < map_side; ++x) *heights.pixel(x, y) = float((x * ramp_u + (map_side - y) * ramp_v) / 64);
    return heights;
}

/// Waves of 16 texels with slopes up to 1, quantised to multiples of `step`. Step 0: not quantised.
Image stepped_waves(double step) {
    constexpr double w = 2 * glm::pi<double>() / 16, amplitude = 1 / w;
    Image heights(map_side, map_side, 1);
    for (int y = 0; y < map_side; ++y)
        for (int x = 0; x < map_side; ++x) {
            const double height = amplitude * std::sin(w * x) * std::sin(w * y);
            *heights.pixel(x, y) = float(step > 0 ? std::round(height / step) * step : height);
        }
    return heights;
}

glm::dvec3 vector_of(const Image& normals, int x, int y) {
    const float* const texel = normals.pixel(x, y);
    return {texel[0] * 2.0 - 1, texel[1] * 2.0 - 1, texel[2] * 2.0 - 1};
}

using NormalsOf = std::function<Image(const Image& heights, double texels)>;

/// Collects the angles to the exact normals, which `exact` returns for a texel.
template <class Exact>
Tally tally_of(const Image& normals, Exact exact) {
    Tally tally;
    for (int y = border; y < map_side - border; ++y)
        for (int x = border; x < map_side - border; ++x) {
            const glm::dvec3 measured = vector_of(normals, x, y), truth = exact(x, y);
            if (!(std::abs(glm::length(measured) - 1) < 1e-3))
                tally.lost();
            else
                tally.add(degrees_between(measured, truth));
        }
    return tally;
}

struct Method {
    std::string name;
    NormalsOf normals;
    bool peer = false;
};

std::vector<Method> methods() {
    std::vector<Method> all;
    for (const auto& [name, filter] : slope_filters)
        all.push_back({name, [filter = filter](const Image& heights, double texels) {
                           return normals_from_heights(
                               heights, {.texels_u = texels, .texels_v = texels, .filter = filter, .wrap = false});
                       }});
    all.push_back({"usual",
                   [](const Image& heights, double texels) {
                       Image normals(heights.width, heights.height, 3);
                       usual_normals(heights, texels, normals);
                       return normals;
                   },
                   true});
    if (has_peers())
        all.push_back(
            {"OpenImageIO",
             [](const Image& heights, double texels) { return normals_of_slopes(openimageio_slopes(heights), texels); },
             true});
    return all;
}

}  // namespace

std::vector<BenchScene> height_sweeps(const BenchSettings& settings) {
    std::vector<SweptMethod> by_slope, by_step;
    for (const Method& method : methods()) {
        const bool usual = method.name == "usual";
        by_slope.push_back(
            {method.name, 1e-4,
             usual         ? "The square of a slope of 1e19 leaves the range of a float, and the normal is 0."
             : method.peer ? "Its slopes are floats; the normal is ours, in double precision."
                           : "Slopes beyond 1e18 are shortened to it together, which keeps their direction.",
             [normals = method.normals](double slope) {
                 return tally_of(normals(ramp(), 64 * slope),
                                 [slope](int, int) { return glm::dvec3(-slope * ramp_u, -slope * ramp_v, 1); })
                     .largest(slope);
             },
             method.peer});
        by_step.push_back(
            {method.name, 1, "A step that heights are stored in is a slope that is not there: smoothing across helps.",
             [normals = method.normals](double step) {
                 const Image whole = normals(stepped_waves(0), 1);
                 return tally_of(normals(stepped_waves(step), 1), [&](int x, int y) { return vector_of(whole, x, y); })
                     .mean(step);
             },
             method.peer});
    }
    return {sweep_scene("heights-slope", "slope", "degree", decades(-9, 25, settings.quick ? 34.0 / 4 : 2), by_slope),
            sweep_scene("heights-step", "step between stored heights, texels", "degree",
                        decades(-7, 0, settings.quick ? 1.75 : 0.5), by_step)};
}

}  // namespace relief::measure
