// Maps of waves that tile: sums of cosines, in closed form and as images.
#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// A wave amplitude * cos(2 pi dot(k, uv) + phase). Wave numbers are whole, so that a map of waves tiles.
struct PlaneWave {
    glm::ivec2 k;
    double amplitude, phase;  ///< metres; radians
};

struct WaveSpectrum {
    double lowest, highest;  ///< wave numbers, waves per tile
    double course, spread;   ///< mean angle to the v axis, and the largest deviation from it; radians
    double fall;             ///< amplitude falls with this power of the wave number
    unsigned seed;
};
/// Returns `count` waves of a spectrum, the same on every machine. No two have the same or opposite wave numbers, so
/// the spectrum must have room for that many. The significant wave height, four times the root mean square, is one
/// metre.
std::vector<PlaneWave> random_waves(const WaveSpectrum& spectrum, int count);

/// Returns the means of the squared slopes along u and along v, and of their product, where a tile is `metres` wide.
glm::dvec3 slope_moments(std::span<const PlaneWave> waves, double metres);

/// Maps at the centres of texels, for one tile. Row 0 is at the top (v = 1).
struct WaveMaps {
    Image waves;    ///< slopes along u and v, height in metres; floats
    Image moments;  ///< squared slope along u, along v, and their product; floats
    Image normals;  ///< unit normal with z upwards, (n + 1) / 2 in 8 bits
};
/// Returns the maps of a sum of waves where a tile is `metres` wide. `texels`, along each side, is a power of two.
WaveMaps wave_maps(std::span<const PlaneWave> waves, int texels, double metres);

/// Returns the maps of square heights that tile, of the same size. They are shifted and scaled so that their mean is 0
/// and the significant wave height is one metre; equal heights become 0. Slopes are central differences.
WaveMaps wave_maps_of(const Image& heights, double metres);

/// What a level of detail must know of waves.
struct WaveMeasures {
    glm::dvec3 moments{0};         ///< as of slope_moments()
    double highest = 0;            ///< upper bound of the height, metres
    double steepest = 0;           ///< of maps without a formula: the largest slope of a texel
    std::vector<PlaneWave> waves;  ///< of maps without a formula: one of the same mean squared height and slope
};
WaveMeasures measures_of(const std::vector<PlaneWave>& waves, double metres);
WaveMeasures measures_of(const WaveMaps& maps, double metres);

}  // namespace relief
