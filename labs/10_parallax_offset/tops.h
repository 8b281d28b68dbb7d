// The highest heights near each block of a map: what lets the exact hit pass over what it cannot meet.
#pragma once

#include <algorithm>
#include <array>
#include <glm/glm.hpp>

#include "framework/image/image.h"

namespace relief::offsets {

/// For each texel the highest value of those at most `reach` columns and rows away. The image repeats.
inline Image highest_near(const Image& image, int reach) {
    Image across(image.width, image.height, 1), result = across;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int i = x - reach; i <= x + reach; ++i) {
                const int column = (i % image.width + image.width) % image.width;
                *across.pixel(x, y) = std::max(*across.pixel(x, y), *image.pixel(column, y));
            }
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int i = y - reach; i <= y + reach; ++i) {
                const int row = (i % image.height + image.height) % image.height;
                *result.pixel(x, y) = std::max(*result.pixel(x, y), *across.pixel(x, row));
            }
    return result;
}

/// One texel for each block of `side` x `side` cells; a cell goes from a texel to the next. Its four channels are the
/// highest height in the block, and in it and the 1, 3 and 8 blocks around. The map repeats; its sides are multiples of
/// `side`, or a single block covers them.
inline Image block_tops(const Image& heights, int side) {
    const glm::ivec2 size(heights.width, heights.height), block = glm::min(size, side), count = size / block;
    Image highest(count.x, count.y, 1), tops(count.x, count.y, 4);
    for (int y = 0; y < count.y; ++y)
        for (int x = 0; x < count.x; ++x)
            for (int v = y * block.y; v <= (y + 1) * block.y; ++v)
                for (int u = x * block.x; u <= (x + 1) * block.x; ++u) {  // rows are counted from below, as cells are
                    float& top = *highest.pixel(x, count.y - 1 - y);
                    top = std::max(top, *heights.pixel(u % size.x, size.y - 1 - v % size.y));
                }
    constexpr std::array reaches = {0, 1, 3, 8};
    for (size_t k = 0; k < reaches.size(); ++k) {
        const Image near = highest_near(highest, reaches[k]);
        for (size_t i = 0; i < near.values.size(); ++i) tops.values[i * 4 + k] = near.values[i];
    }
    return tops;
}

}  // namespace relief::offsets
