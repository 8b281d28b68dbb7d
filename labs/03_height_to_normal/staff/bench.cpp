// Height map to normal map: filters, precisions and threads, compared with memcpy of as many bytes.
#include <cmath>
#include <cstring>
#include <memory>

#include "framework/core/base/parallel.h"
#include "framework/staff/measure/bench.h"
#include "framework/staff/measure/peers.h"
#include "framework/staff/measure/usual.h"
#include "framework/staff/reference/degrees.h"
#include "framework/staff/reference/normals.h"

#include <glm/glm.hpp>

namespace relief::measure {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int error_side = 256;                          // side of the map for errors
constexpr double wavelength = 16;                        // in texels
constexpr double amplitude = wavelength / (2 * pi) * 2;  // height of 1 in texels, so that slopes reach 1

/// A tile of crossed waves with heights in [0, 1], before quantisation.
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

/// Returns the error of the stored normals of wave_map().
BenchError error_of(const Image& normals) {
    const double w = 2 * pi / wavelength;
    std::vector<double> errors;
    for (int y = 0; y < error_side; ++y)
        for (int x = 0; x < error_side; ++x) {
            const float* const texel = normals.pixel(x, y);
            const glm::dvec3 measured(texel[0] * 2.0 - 1, texel[1] * 2.0 - 1, texel[2] * 2.0 - 1);
            // Rows run down, v runs up.
            const glm::dvec3 exact(-amplitude * 0.5 * w * std::cos(w * x) * std::sin(w * y),
                                   amplitude * 0.5 * w * std::sin(w * x) * std::cos(w * y), 1);
            errors.push_back(degrees_between(measured, exact));
        }
    return error_figures(std::move(errors), "degree");
}

struct Maps {
    int side;
    Image heights, normals;
    std::vector<char> from, to;

    void make() {
        if (heights.width > 0) return;
        heights = Image(side, side, 1);
        normals = Image(side, side, 3);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) *heights.pixel(x, y) = float(wave(x, y));
    }
};

/// Adds methods to the scene of this topic. All of them share one pair of maps.
class NormalsScene {
public:
    explicit NormalsScene(bool quick) : maps_(std::make_shared<Maps>()) { maps_->side = quick ? 512 : 4096; }

    void add_memcpy(unsigned threads) {
        const size_t size = texels() * size_t(bytes_per_texel) / 2;  // half is read, half is written
        add("memcpy", 0, threads, [maps = maps_, threads, size] {
            if (maps->from.empty()) {
                maps->from.assign(size, 1);
                maps->to.assign(size, 2);
            }
            parallel_pieces(maps->from.size(), 1, threads, [&](size_t begin, size_t end) {
                std::memcpy(maps->to.data() + begin, maps->from.data() + begin, end - begin);
            });
        });
    }

    /// `bits` of the heights only affects the error: in memory they are floats.
    void add_filter(const char* name, SlopeFilter filter, int bits, unsigned threads) {
        add(
            name, bits, threads,
            [maps = maps_, threads, filter] {
                normals_from_heights(maps->heights, {.texels_u = 4, .texels_v = 4, .filter = filter}, maps->normals,
                                     threads);
            },
            [filter, bits] {
                return error_of(normals_from_heights(wave_map(bits),
                                                     {.texels_u = amplitude, .texels_v = amplitude, .filter = filter}));
            });
    }

    void add_usual() {
        add(
            "usual", 32, 1, [maps = maps_] { usual_normals(maps->heights, 4, maps->normals); },
            [] {
                Image normals(error_side, error_side, 3);
                usual_normals(wave_map(32), amplitude, normals);
                return error_of(normals);
            });
        scene.methods.back().peer = true;
    }

    void add_openimageio() {
        add(
            "OpenImageIO", 32, hardware_threads(), [maps = maps_] { openimageio_slopes(maps->heights); },
            [] { return error_of(normals_of_slopes(openimageio_slopes(wave_map(32)), amplitude)); });
        scene.methods.back().peer = true;
    }

    BenchScene scene{{}, "texel"};

private:
    static constexpr double bytes_per_texel = 16;  // 4 read, 12 written

    size_t texels() const { return size_t(maps_->side) * size_t(maps_->side); }

    /// `bits` 0: the knob does not apply. `error` may be empty.
    void add(const char* name, int bits, unsigned threads, const std::function<void()>& run,
             const std::function<BenchError()>& error = {}) {
        BenchKnobs knobs = {{"threads", std::to_string(threads)}};
        if (bits > 0) knobs.emplace_back("bits", std::to_string(bits));
        scene.methods.push_back({name, knobs, [maps = maps_, items = texels(), run, error, is_parallel = threads > 1] {
                                     maps->make();
                                     return BenchSubject{.items = items,
                                                         .bytes_per_item = bytes_per_texel,
                                                         .error = error ? error() : BenchError{},
                                                         .run = run,
                                                         .is_parallel = is_parallel};
                                 }});
    }

    std::shared_ptr<Maps> maps_;
};

std::vector<BenchScene> normals_scenes(const BenchSettings& settings) {
    const unsigned most_threads = std::min(2u, hardware_threads());
    NormalsScene normals(settings.quick);
    for (unsigned threads = 1; threads <= most_threads; ++threads) {
        normals.add_memcpy(threads);
        for (const auto& [name, filter] : slope_filters)
            for (const int bits : threads == most_threads ? std::vector{8, 16, 32} : std::vector{32})
                normals.add_filter(name, filter, bits, threads);
    }
    normals.add_usual();
    if (has_peers()) normals.add_openimageio();
    return {normals.scene};
}

}  // namespace

const TopicRegistration normals_topic(
    {.name = "normals",
     .help = "height map to normal map; errors on waves of 16 texels with slopes up to 1",
     .question = "Which filter turns heights into the best normals for its time?",
     .scenes = normals_scenes,
     .labs = {"03"}});

}  // namespace relief::measure
