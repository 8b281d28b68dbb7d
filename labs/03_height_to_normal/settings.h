// The knobs of lab 03. Each choice has one table: its values, their names, and their defines in the shaders.
#pragma once

#include <glm/glm.hpp>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/choices.h"
#include "framework/library/maps/line_slopes.h"
#include "framework/library/maps/own_picture.h"

namespace relief::heights {

/// The knobs that the maps depend on.
struct MapSettings {
    enum Source { waves, bricks, colors, own };
    static constexpr auto sources = choices<Source>({{waves, "waves"}, {bricks, "bricks"}, {colors, "colors"}});
    enum Where { gpu, cpu };
    static constexpr auto places = choices<Where>({{gpu, "gpu"}, {cpu, "cpu"}});
    static constexpr std::array sizes = {"32", "64", "128", "256"};  // 32 << size_choice
    static constexpr std::array bit_counts = {"float", "16", "8"};   // 32 >> bits_choice

    int source = waves, size_choice = 1, bits_choice = 0, where = gpu;
    bool wrap = true;
    float depth = 14, stretch = 1, fine = 1, middle = 1, coarse = 1;
    bool operator==(const MapSettings&) const = default;

    static constexpr int picture_size = 256;  ///< texels along each side of all sources but the waves
    int size() const { return source == waves ? 32 << size_choice : picture_size; }
    int bits() const { return 32 >> bits_choice; }
    /// Returns a height of 1, in texels along u and along v.
    glm::dvec2 texels() const { return {depth / stretch, depth}; }
    bool keeps_strengths() const { return fine == 1 && middle == 1 && coarse == 1; }
    bool has_known_slope() const { return source == waves && keeps_strengths(); }
};

/// Returns the user's picture as the lab takes it. A grey picture has one channel and is taken for heights.
Image own_picture(const Image& picture, std::vector<std::string>& notes);

struct Settings {
    enum View { every, one };
    static constexpr auto views = choices<View>({{every, "every"}, {one, "one"}});
    static constexpr auto filters = choices<SlopeFilter>({{SlopeFilter::forward, "forward"},
                                                          {SlopeFilter::central, "central"},
                                                          {SlopeFilter::sobel, "sobel", "SOBEL"},
                                                          {SlopeFilter::scharr, "scharr"},
                                                          {SlopeFilter::fourth_order, "fourth-order"},
                                                          {SlopeFilter::spline, "spline"}});
    enum Show { half_and_half, light, error_map, occlusion, gloss };
    static constexpr auto shows = choices<Show>({{half_and_half, "half-and-half", "ERROR"},
                                                 {light, "light"},
                                                 {error_map, "error", "ERROR"},
                                                 {occlusion, "occlusion", "DERIVED"},
                                                 {gloss, "gloss", "DERIVED"}});

    int view = every, filter = int(SlopeFilter::sobel), show = half_and_half, repeat = 2;
    float light_yaw = -50, light_height = 1.1f;
    MapSettings map;
    OwnPicture own{own_picture};

    bool shows_error() const { return (show == half_and_half || show == error_map) && map.has_known_slope(); }
    bool is_derived() const { return show == occlusion || show == gloss; }
    /// Returns half the size of the wall, metres.
    glm::dvec2 wall() const { return glm::dvec2(std::min(1.0f, map.stretch), std::min(1.0f, 1 / map.stretch)); }

    // The source of the maps.
    bool has_colors() const {
        return map.source == MapSettings::colors || (map.source == MapSettings::own && own.image().channels == 3);
    }
    Image color_picture() const;
    Image stored_heights() const;

    void knobs(Knobs& knobs);
};

}  // namespace relief::heights
