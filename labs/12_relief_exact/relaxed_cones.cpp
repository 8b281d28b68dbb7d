#include "relaxed_cones.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>

#include "framework/core/base/parallel.h"
#include "framework/library/maps/skips.h"

namespace relief::exact {
namespace {

/// Bilinear heights of a map that repeats, row 0 lowest.
class RepeatedHeights {
public:
    explicit RepeatedHeights(const Image& image) : image_(image) {}
    float at(int x, int y) const {
        return *image_.pixel(x & (image_.width - 1), image_.height - 1 - (y & (image_.height - 1)));
    }
    float between(float x, float y) const {
        const float left = std::floor(x), low = std::floor(y), u = x - left, v = y - low;
        const int i = int(left), j = int(low);
        return (at(i, j) * (1 - u) + at(i + 1, j) * u) * (1 - v) + (at(i, j + 1) * (1 - u) + at(i + 1, j + 1) * u) * v;
    }

private:
    const Image& image_;
};

}  // namespace

Image relaxed_cone_map(const Image& heights, unsigned threads) {
    constexpr int directions = 32;
    std::array<glm::vec2, directions> ways;
    for (int i = 0; i < directions; ++i) {
        // Opposite directions follow each other, so that the search ends early.
        const double angle = (i / 2 + (i % 2) * (directions / 2)) * glm::two_pi<double>() / directions;
        ways[size_t(i)] = {float(std::cos(angle)), float(std::sin(angle))};
    }
    const float highest = *std::max_element(heights.values.begin(), heights.values.end());
    const int reach = std::min(relaxed_reach, std::max(1, heights.width / 2));
    const RepeatedHeights relief(heights);
    Image cones(heights.width, heights.height, 1);
    parallel_pieces(size_t(heights.height), 1, threads, [&](size_t begin, size_t end) {
        for (int y = int(begin); y < int(end); ++y)
            for (int x = 0; x < heights.width; ++x) {
                const float foot = relief.at(x, y);
                float widest = foot < 1 ? std::min(float(reach) / (1 - foot), cone_widest) : cone_widest;
                const auto ends_at = [&](float r, float height) {
                    if (height > foot) widest = std::min(widest, r / (height - foot));
                };
                for (const glm::vec2 way : ways) {
                    // From height 1 above the texel the surface at r is seen at this slope. Where the slope grows with
                    // r, the surface faces away: there a ray that is inside comes out.
                    float before = foot, slope = 1e30f;
                    for (int step = 1; step <= reach; ++step) {
                        const auto r = float(step);
                        if (r - 1 >= widest * (highest - foot)) break;
                        const float height = relief.between(float(x) + r * way.x, float(y) + r * way.y);
                        const float seen = (1 - height) / r;
                        if (seen > slope) ends_at(r - 1, before), ends_at(r, height);
                        before = height, slope = seen;
                    }
                }
                *cones.pixel(x, heights.height - 1 - y) = widest;
            }
    });
    return cones;
}

}  // namespace relief::exact
