// The water of lab 15: how high and how often the two maps of waves lie on it. A map may be of the user's files.
#pragma once

#include <array>
#include <tuple>

#include "framework/core/lab/lab.h"
#include "framework/library/kit/kept.h"
#include "framework/library/maps/own_picture.h"
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
    void file_knobs(Knobs& knobs);
    /// Returns whether a map is not that of the formula.
    bool has_own() const { return own_[0].is_there() || own_[1].is_there(); }
    bool has_own_heights(int map) const { return own_[size_t(map)].has_heights > 0; }
    /// All that the water depends on. The last number increases with each file that is read.
    using Key = std::tuple<int, std::array<float, 2>, std::array<float, 2>, float, std::array<int, 4>, int>;
    Key key() const;

    bool is_used(int map) const { return (maps == 0 || maps == map + 1) && amplitudes[size_t(map)] > 0; }
    /// Returns the maps that are used.
    std::vector<Layer> layers() const;
    /// Returns the significant wave height of a map in metres, scaled so that slopes fit the wind.
    double amplitude(int map) const;

    /// The maps as they are in their textures: see WaveMaps.
    const Texture& waves(int map) const { return textures(map).waves; }
    const Texture& normals(int map) const { return textures(map).normals; }

    /// Returns an upper bound of the height of the sea, metres.
    double highest() const;
    /// Returns an upper bound of the slope: five times the root mean square of a map by the formula, which few texels
    /// exceed, and the largest slope of a user's map.
    double steepest() const;
    /// Returns the length of the longest segment whose error is at most `tolerated` metres, as an exponent of 2 of
    /// metres. The error is twice the root mean square over all waves.
    double segment_exponent(double tolerated) const;

    /// Sets the uniforms of shaders/15_ocean/maps.glsl and the waves' formula. Places are relative to the eye.
    void set(const Program& program, const glm::dvec3& eye, double time) const;

private:
    struct Textures {
        Texture waves, moments, normals;
    };
    /// The user's files for one map.
    struct Own {
        OwnPicture heights, normals;
        int has_heights = 0, has_normals = 0;  ///< 1: a file
        Own();
        bool is_there() const { return has_heights > 0 || has_normals > 0; }
    };

    const WaveMeasures& measures(int map) const;
    const Textures& textures(int map) const;
    double segment_error(const std::vector<Layer>& used, double length) const;

    std::array<Own, 2> own_;
    /// By whether the heights are the user's, and the version of these; textures also by that of the normals.
    mutable std::array<Kept<WaveMeasures, int, int>, 2> measures_;
    mutable std::array<Kept<Textures, int, int, int, int>, 2> textures_;
};

}  // namespace relief::ocean
