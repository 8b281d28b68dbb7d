// The water of lab 15: how high and how often the two maps of waves lie on it.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include "framework/core/lab/lab.h"
#include "task.h"
#include "truth.h"
#include "waves.h"

namespace relief::ocean {

class Water {
public:
    static constexpr std::array choices_of_maps = {"both", "first", "second"};
    static constexpr double endless = 20;  ///< exponent of 2 of a segment as long as the sea
    int maps = 0;
    std::array<float, 2> tiles = {0.16f, 2.6f};       ///< per tile_metres
    std::array<float, 2> amplitudes = {1.2f, 0.08f};  ///< significant wave heights, metres
    float wind = 6;                                   ///< metres per second; 0: `amplitudes` as they are

    bool is_used(int map) const { return (maps == 0 || maps == map + 1) && amplitudes[size_t(map)] > 0; }

    /// Returns the significant wave height of a map in metres, scaled so that slopes fit the wind.
    double amplitude(int map) const {
        double square = 0;
        for (size_t i = 0; i < 2; ++i) {
            const glm::dvec3 moments = slope_moments(int(i)) * std::pow(double(amplitudes[i] * tiles[i]), 2);
            square += moments.x + moments.y;
        }
        // Cox and Munk 1954: the mean squared slope of a clean sea.
        const double law = 0.003 + 0.00512 * double(wind);
        const double scale = wind > 0 && square > 0 ? std::sqrt(law / square) : 1;
        return scale * double(amplitudes[size_t(map)]);
    }

    /// Returns the maps that are used.
    std::vector<Layer> layers() const {
        std::vector<Layer> used;
        for (int map = 0; map < 2; ++map)
            if (is_used(map))
                used.push_back({.map = map,
                                .amplitude = amplitude(map),
                                .tiles = double(tiles[size_t(map)]),
                                .velocity = velocities[size_t(map)]});
        return used;
    }

    /// The maps as they are in their textures: see MapImages.
    const Texture& waves(int map) const { return textures_[size_t(map)].waves; }
    const Texture& normals(int map) const { return textures_[size_t(map)].normals; }

    /// Returns an upper bound of the height of the sea, metres.
    double highest() const {
        double sum = 0;
        for (const Layer& layer : layers())
            for (const Wave& wave : waves_of(layer.map)) sum += layer.amplitude * std::abs(wave.amplitude);
        return sum;
    }

    /// Returns five times the root mean square of the slope.
    double steepest() const {
        double square = 0;
        for (const Layer& layer : layers()) {
            const glm::dvec3 moments =
                layer.amplitude * layer.amplitude * layer.tiles * layer.tiles * slope_moments(layer.map);
            square += moments.x + moments.y;
        }
        return 5 * std::sqrt(square);
    }

    /// Returns the length of the longest segment whose error is at most `tolerated` metres, as an exponent of 2 of
    /// metres. The error is twice the root mean square over all waves. A chord of length l of a wave of amplitude a and
    /// k radians per metre is off by a k^2 l^2 / 8, clamped to a.
    double segment_exponent(double tolerated) const {
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

    /// Sets the uniforms of shaders/15_ocean/maps.glsl and the waves' formula. Places are relative to the eye.
    void set(const Program& program, const glm::dvec3& eye, double time) {
        program.set("u_amplitude", glm::vec2(amplitude(0), amplitude(1)));
        program.set("u_tiles", glm::vec2(tiles[0], tiles[1]));
        glm::vec4 offset(0);
        for (int map = 0; map < 2; ++map) {
            const glm::dvec2 moved = time == 0 ? glm::dvec2(0) : scroll(velocities[size_t(map)], time),
                             below = double(tiles[size_t(map)]) / tile_metres * glm::dvec2(eye.x, eye.z),
                             rest = below - glm::floor(below) + moved;
            offset[map * 2] = float(rest.x), offset[map * 2 + 1] = float(rest.y);
            for (int i = 0; i < waves_a_map; ++i) {
                const Wave& wave = waves_of(map)[size_t(i)];
                program.set(fmt::format("u_waves[{}]", map * waves_a_map + i).c_str(),
                            glm::vec4(wave.k.x, wave.k.y, wave.amplitude, wave.phase));
            }
            const std::string number = std::to_string(map + 1);
            const Textures& of = textures_[size_t(map)];
            program.set(("s_waves_" + number).c_str(), 3 * map, of.waves);
            program.set(("s_moments_" + number).c_str(), 3 * map + 1, of.moments);
            program.set(("s_normals_" + number).c_str(), 3 * map + 2, of.normals);
        }
        program.set("u_offset", offset);
    }

private:
    /// Tiles per second. They are binary fractions, so that the sea repeats exactly after 128 seconds.
    static constexpr std::array<glm::dvec2, 2> velocities = {{{1.0 / 128, 9.0 / 128}, {-5.0 / 128, 31.0 / 128}}};

    static double segment_error(const std::vector<Layer>& used, double length) {
        double sum = 0;
        for (const Layer& layer : used)
            for (const Wave& wave : waves_of(layer.map)) {
                const double turns = glm::length(glm::dvec2(wave.k)) * layer.tiles / tile_metres * length,
                             angle = 2 * glm::pi<double>() * turns,
                             part = layer.amplitude * wave.amplitude * std::min(1.0, angle * angle / 8);
                sum += part * part / 2;
            }
        return 2 * std::sqrt(sum);
    }

    struct Textures {
        Texture waves, moments, normals;
        explicit Textures(int map)
            : waves(fmt::format("waves {}", map + 1), [map] { return make_maps(map).waves; }),
              moments(fmt::format("moments {}", map + 1), [map] { return make_maps(map).moments; }),
              normals(fmt::format("normals {}", map + 1), [map] { return make_maps(map).normals; }) {}
    };
    std::array<Textures, 2> textures_ = {Textures(0), Textures(1)};
};

}  // namespace relief::ocean
