#include "water.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>

#include "framework/core/base/error.h"
#include "framework/library/kit/uniforms.h"
#include "framework/library/maps/heights.h"
#include "framework/library/maps/normals.h"
#include "framework/library/maps/resample.h"
#include "task.h"

namespace relief::ocean {
namespace {

constexpr double two_pi = 2 * glm::pi<double>();
/// Tiles per second. They are binary fractions, so that the sea repeats exactly after 128 seconds.
constexpr std::array<glm::dvec2, 2> velocities = {{{1.0 / 128, 9.0 / 128}, {-5.0 / 128, 31.0 / 128}}};

/// Returns the heights of a user's picture, of map_texels a side. Throws Error, without a place, if the picture has no
/// heights or a single one.
Image own_heights(const Image& picture, std::vector<std::string>& notes) {
    Heights found = heights_in(picture);
    notes = std::move(found.notes);
    Image heights = resampled(found.image, map_texels, map_texels);
    const auto [low, high] = std::minmax_element(heights.values.begin(), heights.values.end());
    if (!(*high > *low)) throw Error("has a single height: waves have crests and troughs");
    return heights;
}

/// Returns the normals of a user's picture, of map_texels a side. Throws Error, without a place, as normals_in() does,
/// and for a picture whose colours do not point upwards.
Image own_normals(const Image& picture, std::vector<std::string>& notes) {
    Image whole = normals_in(picture, notes);
    double up = 0;
    size_t steep = 0;
    for (size_t i = 2; i < whole.values.size(); i += 3) {
        constexpr float lowest = 0.55f;  // a slope of 10 and more has no end
        steep += whole.values[i] < lowest;
        up += double(whole.values[i] = std::max(whole.values[i], lowest));
    }
    if (up < 0.7 * double(whole.pixel_count())) throw Error("does not point upwards: a normal map is mostly blue");
    if (steep > 0) notes.push_back(fmt::format("{} texels are steeper than 84 degrees: clamped", steep));
    Image normals = resampled(whole, map_texels, map_texels);
    normals.bits = 8;
    return normals;
}

}  // namespace

Water::Own::Own() : heights(own_heights), normals(own_normals) {}

void Water::file_knobs(Knobs& knobs) {
    static constexpr std::array by_formula = {"formula"}, of_heights = {"of-heights"};
    knobs.choice_or_file("heights_1", own_[0].has_heights, own_[0].heights, by_formula, "heights of the first map");
    knobs.choice_or_file("heights_2", own_[1].has_heights, own_[1].heights, by_formula, "heights of the second map");
    knobs.choice_or_file("normals_1", own_[0].has_normals, own_[0].normals, of_heights, "normals of the first map");
    knobs.choice_or_file("normals_2", own_[1].has_normals, own_[1].normals, of_heights, "normals of the second map");
}

Water::Key Water::key() const {
    std::array<int, 4> has_own{};
    int files = 0;
    for (size_t i = 0; i < 2; ++i) {
        has_own[2 * i] = own_[i].has_heights, has_own[2 * i + 1] = own_[i].has_normals;
        files += own_[i].heights.version() + own_[i].normals.version();
    }
    return {maps, tiles, amplitudes, wind, has_own, files};
}

std::vector<Layer> Water::layers() const {
    std::vector<Layer> used;
    for (int map = 0; map < 2; ++map)
        if (is_used(map))
            used.push_back({.map = map,
                            .amplitude = amplitude(map),
                            .tiles = double(tiles[size_t(map)]),
                            .velocity = velocities[size_t(map)]});
    return used;
}

double Water::amplitude(int map) const {
    double square = 0;
    for (size_t i = 0; i < 2; ++i) {
        const glm::dvec3 moments = measures(int(i)).moments * std::pow(double(amplitudes[i] * tiles[i]), 2);
        square += moments.x + moments.y;
    }
    // Cox and Munk 1954: the mean squared slope of a clean sea.
    const double law = 0.003 + 0.00512 * double(wind);
    const double scale = wind > 0 && square > 0 ? std::sqrt(law / square) : 1;
    return scale * double(amplitudes[size_t(map)]);
}

// ---- bounds, for the grid

double Water::highest() const {
    double sum = 0;
    for (const Layer& layer : layers()) sum += layer.amplitude * measures(layer.map).highest;
    return sum;
}

double Water::steepest() const {
    double square = 0, own = 0;
    for (const Layer& layer : layers()) {
        const WaveMeasures& of = measures(layer.map);
        const double scale = layer.amplitude * layer.tiles;
        if (has_own_heights(layer.map))
            own += scale * of.steepest;
        else
            square += scale * scale * (of.moments.x + of.moments.y);
    }
    return 5 * std::sqrt(square) + own;
}

double Water::segment_exponent(double tolerated) const {
    constexpr double first = -10;
    constexpr int steps = 16, count = 20 * steps;  // to an exponent of 10
    const std::vector<Layer> used = layers();
    int too_long = 0, beyond = count;  // the first length that is too long is in [too_long, beyond]
    while (too_long < beyond) {
        const int middle = (too_long + beyond) / 2;
        if (segment_error(used, std::exp2(first + double(middle) / steps)) <= tolerated)
            too_long = middle + 1;
        else
            beyond = middle;
    }
    return too_long == count ? endless : first + double(std::max(0, too_long - 1)) / steps;
}

/// A chord of length l of a wave of amplitude a and k radians per metre is off by a k^2 l^2 / 8, clamped to a.
double Water::segment_error(const std::vector<Layer>& used, double length) const {
    double sum = 0;
    for (const Layer& layer : used)
        for (const PlaneWave& wave : measures(layer.map).waves) {
            const double turns = glm::length(glm::dvec2(wave.k)) * layer.tiles / tile_metres * length,
                         angle = two_pi * turns,
                         part = layer.amplitude * wave.amplitude * std::min(1.0, angle * angle / 8);
            sum += part * part / 2;
        }
    return 2 * std::sqrt(sum);
}

const WaveMeasures& Water::measures(int map) const {
    const Own& own = own_[size_t(map)];
    return measures_[size_t(map)].get({own.has_heights, own.heights.version()}, [&] {
        return own.has_heights ? measures_of(wave_maps_of(own.heights.image(), tile_metres), tile_metres)
                               : measures_of(waves_of(map), tile_metres);
    });
}

// ---- on the GPU

void Water::set(const Program& program, const glm::dvec3& eye, double time) const {
    program.set("u_amplitude", glm::vec2(amplitude(0), amplitude(1)));
    program.set("u_tiles", glm::vec2(tiles[0], tiles[1]));
    std::vector<glm::vec4> waves_of_maps;
    glm::vec4 offset(0);
    for (int map = 0; map < 2; ++map) {
        const glm::dvec2 moved = time == 0 ? glm::dvec2(0) : scroll(velocities[size_t(map)], time),
                         below = double(tiles[size_t(map)]) / tile_metres * glm::dvec2(eye.x, eye.z),
                         rest = below - glm::floor(below) + moved;
        offset[map * 2] = float(rest.x), offset[map * 2 + 1] = float(rest.y);
        for (const PlaneWave& wave : waves_of(map))
            waves_of_maps.emplace_back(wave.k.x, wave.k.y, wave.amplitude, wave.phase);
        const std::string number = std::to_string(map + 1);
        const Textures& of = textures(map);
        program.set(("s_waves_" + number).c_str(), 3 * map, of.waves);
        program.set(("s_moments_" + number).c_str(), 3 * map + 1, of.moments);
        program.set(("s_normals_" + number).c_str(), 3 * map + 2, of.normals);
    }
    set_each<glm::vec4>(program, "u_waves", waves_of_maps);
    program.set("u_offset", offset);
}

const Water::Textures& Water::textures(int map) const {
    const Own& own = own_[size_t(map)];
    return textures_[size_t(map)].get(
        {own.has_heights, own.heights.version(), own.has_normals, own.normals.version()}, [&] {
            const auto made = std::make_shared<Kept<WaveMaps>>();  // when a texture is first bound
            const auto maps_made = [made, map, heights = own.has_heights ? own.heights.image() : Image(),
                                    normals = own.has_normals ? own.normals.image() : Image()]() -> const WaveMaps& {
                return made->get({}, [&] {
                    WaveMaps all = heights.values.empty() ? make_maps(map) : wave_maps_of(heights, tile_metres);
                    if (!normals.values.empty()) all.normals = normals;
                    return all;
                });
            };
            return Textures{Texture(fmt::format("waves {}", map + 1), [=] { return maps_made().waves; }),
                            Texture(fmt::format("moments {}", map + 1), [=] { return maps_made().moments; }),
                            Texture(fmt::format("normals {}", map + 1), [=] { return maps_made().normals; })};
        });
}

}  // namespace relief::ocean
