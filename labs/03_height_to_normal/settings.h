// The knobs of lab 03. Each choice has one table: its values, their names, and their defines in the shaders.
#pragma once

#include <glm/glm.hpp>

#include "framework/height/lines.h"
#include "framework/image/own_picture.h"
#include "framework/kit/choices.h"
#include "framework/lab/lab.h"

namespace relief::heights {

/// The knobs that the maps depend on.
struct MapSettings {
    enum Source { waves, bricks, colors, own };
    static constexpr auto sources = Choices({{"waves"}, {"bricks"}, {"colors"}});
    static constexpr auto sizes = Choices({{"32"}, {"64"}, {"128"}, {"256"}});
    static constexpr auto bit_counts = Choices({{"float"}, {"16"}, {"8"}});
    enum Where { gpu, cpu };
    static constexpr auto places = Choices({{"gpu"}, {"cpu"}});

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
Image own_picture(Image picture);

struct Settings {
    enum View { every, one };
    static constexpr auto views = Choices({{"every"}, {"one"}});
    static constexpr auto filters = Choices(  // SlopeFilter
        {{"forward"}, {"central"}, {"sobel", "SOBEL"}, {"scharr"}, {"fourth-order"}, {"spline"}});
    enum Show { half_and_half, light, error_map, occlusion, gloss };
    static constexpr auto shows = Choices(
        {{"half-and-half", "ERROR"}, {"light"}, {"error", "ERROR"}, {"occlusion", "DERIVED"}, {"gloss", "DERIVED"}});

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
