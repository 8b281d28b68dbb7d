// Slopes of normals and of heights, and what they have in common.
#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "framework/image/image.h"

namespace relief {

/// dh/du and dh/dv of each texel, v growing up; NaN where a texel has none.
struct Slopes {
    int width = 0, height = 0;
    std::vector<glm::vec2> of;
    const glm::vec2& at(int x, int y) const { return of[size_t(y) * size_t(width) + size_t(x)]; }
};

/// -n.xy / n.z. None where the normal is steeper than 85 degrees.
Slopes slopes_of_normals(std::span<const glm::vec3> normals, int width, int height);

/// By central differences of the mean of the first `channels` channels; none at the border.
Slopes slopes_of_heights(const Image& heights, int first_channel, int channels);

/// Of 2 x 2 texels their mean.
Slopes halved(const Slopes& slopes);

/// The slopes of one height field have d(dh/du)/dv = d(dh/dv)/du: what does not is not one, or green points down.
struct FieldTest {
    size_t count = 0;   ///< texels at which both could be taken
    double up = 0;      ///< 1: a height field; -1: one with green turned around; 0: neither
    double turned = 0;  ///< the same of (y, x): 1: red and green are swapped; -1: the picture is turned by 90 degrees
    int level = 0;      ///< how often the slopes were halved; the level that says most
    double rms = 0;     ///< slope
    double across = 0;  ///< rms slope across the main direction, over that along it: 0 where all lie in one direction
};
FieldTest test_field(const Slopes& slopes);

/// The same for squares of a map, from left to right and down: `up`, or 0 where a square cannot tell. `noise` is the
/// rms of what rounding makes of a slope.
struct SquareTests {
    int side = 0, columns = 0, rows = 0;
    std::vector<double> up;
};
SquareTests test_squares(const Slopes& slopes, double noise);

/// How a map's red and green follow from dh/du and dh/dv of heights: swapped first, then turned around.
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
    bool comparable = false;  ///< the sizes fit, and neither is flat
    double correlation = 0;   ///< of the slopes, by the best of the eight `channels`
    Channels channels = {};
    double strength = 0;  ///< a height of 1, in texels of the normals' map
    Layout layout = {};   ///< of the heights' picture
};
/// The sizes must agree, or one be the other times a power of two.
Agreement agreement(const Slopes& normals, const Image& heights, int first_channel, int channels);

}  // namespace relief
