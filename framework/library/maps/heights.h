// Heights in a picture of the user: which channel they are, which texels have none, and how metres are scaled. All
// commands and labs read heights through this file.
#pragma once

#include <string>
#include <vector>

#include "framework/core/image/image.h"

namespace relief {

/// A height map as the course uses it, and what was done to the picture.
struct Heights {
    Image image;            ///< one channel, finite, in [0, 1]; `bits` of the picture
    Image normals = {};     ///< three channels, if the picture is a normal map with heights in its fourth channel
    int channel = 0;        ///< of the picture
    double low = 0;         ///< the value in the picture that became 0
    double high = 1;        ///< the value in the picture that became 1
    size_t not_finite = 0;  ///< texels that held NaN or infinity
    std::vector<uint8_t> voids = {};  ///< 1 for each texel without a height, whose height was filled; or empty
    /// One line about each change, and about each value that may mean a void.
    std::vector<std::string> notes = {};
};

/// Returns the heights of a picture with any values. Throws Error without a place for a picture with colours, and for
/// one without any height.
///
/// - A picture of one channel, or a grey one, holds heights in its first channel; alpha is no height. The last of two
///   or four channels holds them if the others are all of one colour, or if the first three are a normal map. So it
///   does beside colours, as packed maps have it.
/// - NaN, infinity and the marks of missing data (-9999, -32768, -3.4e38, 32768 in 16 bits ...) are voids. Of floats, a
///   mark is the lowest or highest value if it lies outside of [0, 1], and is farther from all others than these are
///   from each other. A void gets the weighted mean of the heights around it; the map repeats.
/// - Floats beyond [0, 1], such as metres, are scaled so that the lowest is 0 and the highest is 1.
Heights heights_in(Image picture);

/// Returns whether the first three channels of a picture differ by at most 0.02 on average: for floats, 0.02 of the
/// range of the first channel. Texels that are not finite do not count. An image with fewer channels is grey.
bool is_nearly_grey(const Image& picture);

}  // namespace relief
