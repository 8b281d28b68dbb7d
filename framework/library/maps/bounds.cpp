#include "framework/library/maps/bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>

#include "framework/core/base/error.h"

namespace relief {
namespace {

void take_in(float* bounds, const float* other) {
    bounds[0] = std::min(bounds[0], other[0]), bounds[1] = std::max(bounds[1], other[1]);
}

Image cells_of(const Image& heights) {
    Image cells(heights.width, heights.height, 2);
    for (int y = 0; y < heights.height; ++y)
        for (int x = 0; x < heights.width; ++x) {
            const int right = (x + 1) % heights.width, above = (y + heights.height - 1) % heights.height;
            const auto [low, high] = std::minmax({*heights.pixel(x, y), *heights.pixel(right, y),
                                                  *heights.pixel(x, above), *heights.pixel(right, above)});
            cells.pixel(x, y)[0] = low, cells.pixel(x, y)[1] = high;
        }
    return cells;
}

/// Halves both sides, rounded down. Conservative: where a side is odd, neighbouring texels of the result share one
/// texel.
Image half(const Image& bounds) {
    Image result(std::max(1, bounds.width / 2), std::max(1, bounds.height / 2), 2);
    const auto begin = [](int i, int from, int to) { return i * from / to; };
    const auto end = [](int i, int from, int to) { return ((i + 1) * from + to - 1) / to; };
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x) {
            const int left = begin(x, bounds.width, result.width), top = begin(y, bounds.height, result.height);
            float* const texel = result.pixel(x, y);
            std::copy_n(bounds.pixel(left, top), 2, texel);
            for (int v = top; v < end(y, bounds.height, result.height); ++v)
                for (int u = left; u < end(x, bounds.width, result.width); ++u) take_in(texel, bounds.pixel(u, v));
        }
    return result;
}

}  // namespace

std::vector<Image> min_max_mips(const Image& heights) {
    std::vector<Image> levels{cells_of(heights)};
    while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(half(levels.back()));
    return levels;
}

Image min_max_atlas(const Image& heights) {
    const int side = heights.width;
    if (heights.channels != 1 || heights.height != side || !std::has_single_bit(unsigned(side)))
        throw Error(
            fmt::format("the height map of an atlas has one channel and a power of two as its side; this is {}x{}",
                        heights.width, heights.height));
    const std::vector<Image> levels = min_max_mips(heights);
    Image atlas(side + side / 2, side, 2);
    for (size_t k = 0; k < levels.size(); ++k) {
        const int left = k == 0 ? 0 : side, bottom = k == 0 ? 0 : side - (side >> (k - 1));
        const int top = side - bottom - levels[k].height;
        for (int y = 0; y < levels[k].height; ++y)
            std::copy_n(levels[k].pixel(0, y), size_t(levels[k].width) * 2, atlas.pixel(left, top + y));
    }
    return atlas;
}

}  // namespace relief
