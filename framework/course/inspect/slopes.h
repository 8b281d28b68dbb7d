// Slopes of normal maps and height maps, and tests of their agreement.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "framework/core/image/image.h"

namespace relief::inspect {

/// The slopes dh/du and dh/dv of each texel; v grows up. NaN where a texel has none.
struct Slopes {
    int width = 0, height = 0;
    std::vector<glm::vec2> of;
    const glm::vec2& at(int x, int y) const { return of[size_t(y) * size_t(width) + size_t(x)]; }
};

/// Returns -n.xy / n.z; NaN where the normal is steeper than 85 degrees.
Slopes slopes_of_normals(std::span<const glm::vec3> normals, int width, int height);

/// Returns central differences of the mean of `channels` channels, from `first_channel` on. NaN at the border.
Slopes slopes_of_heights(const Image& heights, int first_channel, int channels);

/// Returns the slopes at half the width and height: the mean of every 2 x 2 texels.
Slopes halved(const Slopes& slopes);

/// Tests whether slopes belong to one height field: then d(dh/du)/dv = d(dh/dv)/du. If green points down, the two have
/// opposite signs.
struct FieldTest {
    size_t count = 0;   ///< texels at which both derivatives exist
    double up = 0;      ///< 1: a height field; -1: one with inverted green; 0: neither
    double turned = 0;  ///< the same for (y, x): 1: red and green are swapped; -1: the picture is rotated by 90 degrees
    double rms = 0;     ///< rms of the slopes
    double across = 0;  ///< rms slope across the main direction over that along it; 0 if all lie in one direction
};
FieldTest test_field(const Slopes& slopes);

/// Tests each square of a map, from left to right and top to bottom. A square that is inconclusive gets 0 in `up`.
/// `noise` is the rms error of a slope through rounding.
struct SquareTests {
    int side = 0, columns = 0, rows = 0;
    std::vector<double> up;
};
SquareTests test_squares(const Slopes& slopes, double noise);

/// How a map's red and green follow from dh/du and dh/dv of heights: first swapped, then negated.
struct Channels {
    bool swapped = false, red_turned = false, green_turned = false;
    glm::dvec2 from(glm::dvec2 heights_slope) const;
    bool operator==(const Channels&) const = default;
};

/// A picture mirrored left to right, mirrored top to bottom, then transposed.
struct Layout {
    bool mirrored_u = false, mirrored_v = false, transposed = false;
    bool operator==(const Layout&) const = default;
};
Image laid(const Image& picture, Layout layout);

struct Agreement {
    bool comparable = false;  ///< the sizes match, and neither map is flat
    double correlation = 0;   ///< of the slopes, under the best of the eight `channels`
    Channels channels = {};
    double strength = 0;  ///< a height of 1, in texels of the normal map
    Layout layout = {};   ///< of the height map
};
/// Finds the channels and the layout that fit best. Not comparable unless the sizes are equal, or differ by a power of
/// two.
Agreement agreement(const Slopes& normals, const Image& heights, int first_channel, int channels);

}  // namespace relief::inspect
