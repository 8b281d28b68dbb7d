// The water of lab 15: how high and how often the two maps of waves lie on it. A map may be of the user's files.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>
#include <span>

#include "framework/core/image/own_picture.h"
#include "framework/core/kit/kept.h"
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

    /// The knobs of the user's files.
    void knobs(Knobs& knobs) {
        static constexpr std::array by_formula = {"formula"}, of_heights = {"of-heights"};
        static constexpr std::array names = {"heights_1", "heights_2", "normals_1", "normals_2"};
        for (size_t i = 0; i < 2; ++i)
            knobs.choice_or_file(names[i], own_[i].has_heights, own_[i].heights, by_formula,
                                 i == 0 ? "heights of the first map" : "heights of the second map");
        for (size_t i = 0; i < 2; ++i)
            knobs.choice_or_file(names[2 + i], own_[i].has_normals, own_[i].normals, of_heights,
                                 i == 0 ? "normals of the first map" : "normals of the second map");
    }
    bool has_own_heights(int map) const { return own_[size_t(map)].has_heights > 0; }
    /// Returns whether a map is not that of the formula.
    bool has_own() const { return own_[0].is_there() || own_[1].is_there(); }
    /// Increases with each file that is read.
    int version() const {
        return own_[0].heights.version() + own_[0].normals.version() + own_[1].heights.version() +
               own_[1].normals.version();
    }

    bool is_used(int map) const { return (maps == 0 || maps == map + 1) && amplitudes[size_t(map)] > 0; }

    /// Returns the significant wave height of a map in metres, scaled so that slopes fit the wind.
    double amplitude(int map) const {
        double square = 0;
        for (size_t i = 0; i < 2; ++i) {
            const glm::dvec3 moments = moments_of(int(i)) * std::pow(double(amplitudes[i] * tiles[i]), 2);
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
    const Texture& waves(int map) const { return textures(map).waves; }
    const Texture& normals(int map) const { return textures(map).normals; }

    /// Returns an upper bound of the height of the sea, metres.
    double highest() const {
        double sum = 0;
        for (const Layer& layer : layers()) {
            if (const Own& own = own_[size_t(layer.map)]; own.has_heights > 0) {
                sum += layer.amplitude * own.measures().highest;
                continue;
            }
            for (const Wave& wave : waves_of(layer.map)) sum += layer.amplitude * std::abs(wave.amplitude);
        }
        return sum;
    }

    /// Returns five times the root mean square of the slope.
    double steepest() const {
        double square = 0;
        for (const Layer& layer : layers()) {
            const glm::dvec3 moments =
                layer.amplitude * layer.amplitude * layer.tiles * layer.tiles * moments_of(layer.map);
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
            const Textures& of = textures(map);
            program.set(("s_waves_" + number).c_str(), 3 * map, of.waves);
            program.set(("s_moments_" + number).c_str(), 3 * map + 1, of.moments);
            program.set(("s_normals_" + number).c_str(), 3 * map + 2, of.normals);
        }
        program.set("u_offset", offset);
    }

private:
    /// Tiles per second. They are binary fractions, so that the sea repeats exactly after 128 seconds.
    static constexpr std::array<glm::dvec2, 2> velocities = {{{1.0 / 128, 9.0 / 128}, {-5.0 / 128, 31.0 / 128}}};

    double segment_error(const std::vector<Layer>& used, double length) const {
        double sum = 0;
        for (const Layer& layer : used)
            for (const Wave& wave : spectrum(layer.map)) {
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
        explicit Textures(std::shared_ptr<const MapImages> own)
            : waves("own waves", [own] { return own->waves; }),
              moments("own moments", [own] { return own->moments; }),
              normals("own normals", [own] { return own->normals; }) {}
    };

    /// What is known of own heights without a formula. `wave` is a cosine of the same height and slope.
    struct Measures {
        glm::dvec3 moments{0};
        double highest = 0;
        std::array<Wave, 1> wave{};
    };
    /// The user's files for one map.
    struct Own {
        OwnPicture heights{own_heights}, normals{own_normals};
        int has_heights = 0, has_normals = 0;  ///< 1: a file

        bool is_there() const { return has_heights > 0 || has_normals > 0; }
        const Measures& measures() const {
            return measures_.get({heights.version()}, [this] { return measured(maps_of_heights(heights.image())); });
        }

    private:
        mutable Kept<Measures, int> measures_;
        static Measures measured(const MapImages& images) {
            Measures result;
            const double count = double(images.waves.pixel_count());
            double square = 0;
            for (size_t i = 0; i < images.waves.pixel_count(); ++i) {
                const double height = double(images.waves.values[3 * i + 2]);
                result.highest = std::max(result.highest, std::abs(height)), square += height * height / count;
                for (int c = 0; c < 3; ++c)
                    result.moments[c] += double(images.moments.values[3 * i + size_t(c)]) / count;
            }
            const double amplitude = std::sqrt(2 * square), slope = result.moments.x + result.moments.y;
            const double turns = std::sqrt(slope / std::max(square, 1e-12)) * tile_metres / (2 * glm::pi<double>());
            result.wave[0] = {{std::max(1, int(turns + 0.5)), 0}, amplitude, 0};
            return result;
        }
    };

    glm::dvec3 moments_of(int map) const {
        const Own& own = own_[size_t(map)];
        return own.has_heights > 0 ? own.measures().moments : slope_moments(map);
    }
    std::span<const Wave> spectrum(int map) const {
        const Own& own = own_[size_t(map)];
        return own.has_heights > 0 ? std::span<const Wave>(own.measures().wave) : std::span<const Wave>(waves_of(map));
    }
    const Textures& textures(int map) const {
        const Own& own = own_[size_t(map)];
        return textures_[size_t(map)].get(
            {own.has_heights, own.heights.version(), own.has_normals, own.normals.version()}, [&] {
                if (!own.is_there()) return Textures(map);
                auto images = std::make_shared<MapImages>(own.has_heights > 0 ? maps_of_heights(own.heights.image())
                                                                              : make_maps(map));
                if (own.has_normals > 0) images->normals = own.normals.image();
                return Textures(std::move(images));
            });
    }

    std::array<Own, 2> own_;
    mutable std::array<Kept<Textures, int, int, int, int>, 2> textures_;
};

}  // namespace relief::ocean
