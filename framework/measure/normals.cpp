// Height map to normal map: filters, precisions and threads, beside memcpy of as many bytes.
#include <cmath>
#include <cstring>
#include <memory>

#include "framework/base/parallel.h"
#include "framework/image/normals.h"
#include "framework/measure/topics.h"

#include <glm/glm.hpp>

namespace relief {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int error_side = 256;                          // of the map on which errors are taken
constexpr double wavelength = 16;                        // texels
constexpr double amplitude = wavelength / (2 * pi) * 2;  // what height 1 is worth, so that slopes reach 1

/// A tile of crossed waves with heights in [0, 1]; steps of the precision.
double wave(int x, int y) {
    const double w = 2 * pi / wavelength;
    return 0.5 + 0.5 * std::sin(w * x) * std::sin(w * y);
}

Image wave_map(int bits) {
    Image map(error_side, error_side, 1, bits);
    const double steps = bits == 32 ? 0 : std::exp2(bits) - 1;
    for (int y = 0; y < error_side; ++y)
        for (int x = 0; x < error_side; ++x)
            *map.pixel(x, y) = float(steps > 0 ? std::round(wave(x, y) * steps) / steps : wave(x, y));
    return map;
}

BenchError error_of(SlopeFilter filter, int bits) {
    const Image normals =
        normals_from_heights(wave_map(bits), {.texels_u = amplitude, .texels_v = amplitude, .filter = filter});
    const double w = 2 * pi / wavelength;
    std::vector<double> errors;
    for (int y = 0; y < error_side; ++y)
        for (int x = 0; x < error_side; ++x) {
            const float* const texel = normals.pixel(x, y);
            const glm::dvec3 measured(texel[0] * 2.0 - 1, texel[1] * 2.0 - 1, texel[2] * 2.0 - 1);
            // Rows run down, v runs up.
            const glm::dvec3 exact(-amplitude * 0.5 * w * std::cos(w * x) * std::sin(w * y),
                                   amplitude * 0.5 * w * std::sin(w * x) * std::cos(w * y), 1);
            errors.push_back(
                glm::degrees(std::atan2(glm::length(glm::cross(measured, exact)), glm::dot(measured, exact))));
        }
    return error_figures(std::move(errors), "degree");
}

struct Maps {
    Image heights, normals;
    std::vector<char> from, to;
};

std::vector<BenchMethod> methods(const BenchSettings& settings) {
    const int side = settings.quick ? 512 : 4096;
    const auto maps = std::make_shared<Maps>();
    maps->heights = Image(side, side, 1);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) *maps->heights.pixel(x, y) = float(wave(x, y));
    const size_t texels = maps->heights.pixel_count();
    constexpr double bytes = 16;  // 4 read, 12 written
    maps->from.assign(texels * size_t(bytes) / 2, 1), maps->to.assign(texels * size_t(bytes) / 2, 2);

    std::vector<unsigned> thread_counts = {1};
    if (hardware_threads() > 1) thread_counts.push_back(2);
    std::vector<BenchMethod> result;
    const auto add = [&](const char* name, int bits, unsigned threads, auto run, BenchError error) {
        std::vector<std::pair<std::string, std::string>> knobs = {{"threads", std::to_string(threads)}};
        if (bits > 0) knobs.emplace_back("bits", std::to_string(bits));
        result.push_back({.name = name,
                          .knobs = knobs,
                          .items = texels,
                          .item = "texel",
                          .bytes_per_item = bytes,
                          .run = run,
                          .error = std::move(error)});
    };
    const std::pair<const char*, SlopeFilter> filters[] = {{"forward", SlopeFilter::forward},
                                                           {"central", SlopeFilter::central},
                                                           {"sobel", SlopeFilter::sobel},
                                                           {"scharr", SlopeFilter::scharr},
                                                           {"fourth-order", SlopeFilter::fourth_order},
                                                           {"spline", SlopeFilter::spline}};
    for (const unsigned threads : thread_counts) {
        add("memcpy", 0, threads,
            [maps, threads] {
                parallel_pieces(maps->from.size(), 1, threads, [&](size_t begin, size_t end) {
                    std::memcpy(maps->to.data() + begin, maps->from.data() + begin, end - begin);
                });
            },
            {});
        for (const auto& [name, filter] : filters)
            // How many bits the heights had decides the error alone: in memory they are floats.
            for (const int bits : threads == thread_counts.back() ? std::vector{8, 16, 32} : std::vector{32})
                add(
                    name, bits, threads,
                    [maps, threads, kind = filter] {
                        normals_from_heights(maps->heights, {.texels_u = 4, .texels_v = 4, .filter = kind},
                                             maps->normals, threads);
                    },
                    error_of(filter, bits));
    }
    return result;
}

}  // namespace

BenchTopic normals_topic() {
    return {"normals", "height map to normal map; errors on waves of 16 texels with slopes up to 1", methods};
}

}  // namespace relief
