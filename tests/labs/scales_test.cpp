// A normal map of scales: unit normals that tile, and agree with the heights beside them.
#include "labs/18_moving_frames/scales.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace relief {
namespace {

TEST(Scales, HaveUnitNormalsThatPointOutwards) {
    const Image map = make_scales(64);
    float lowest = 1, highest = 0;
    for (size_t i = 0; i < map.values.size(); i += 4) {
        double squared = 0;
        for (size_t c = 0; c < 3; ++c) squared += std::pow(2 * double(map.values[i + c]) - 1, 2);
        EXPECT_NEAR(squared, 1, 1e-6) << i;  // stored as floats here: rounded to 8 bits when it becomes a texture
        EXPECT_GT(map.values[i + 2], 0.5f) << i;
        lowest = std::min(lowest, map.values[i + 3]), highest = std::max(highest, map.values[i + 3]);
    }
    EXPECT_GE(lowest, 0);
    EXPECT_GT(highest, 0.8f);
    EXPECT_LE(highest, 1);
}

TEST(Scales, RepeatEveryHalfTile) {
    // Two scales from side to side, and two pairs of rows from top to bottom: a shift by half a tile changes nothing.
    const Image map = make_scales(64);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            for (int c = 0; c < 4; ++c) {
                EXPECT_NEAR(map.pixel(x, y)[c], map.pixel((x + 32) % 64, y)[c], 1e-5);
                EXPECT_NEAR(map.pixel(x, y)[c], map.pixel(x, (y + 32) % 64)[c], 1e-5);
            }
}

TEST(Scales, RiseTowardsTheirLowerTips) {
    // Where a normal leans up, the height falls upwards, and the other way round. Edges, where a texel's differences
    // reach across a step, are left out.
    const Image map = make_scales(256);
    int checked = 0;
    for (int y = 1; y < 255; ++y)
        for (int x = 0; x < 256; ++x) {
            const float above = map.pixel(x, y - 1)[3], below = map.pixel(x, y + 1)[3];
            const float leaning = map.pixel(x, y)[1] - 0.5f;
            if (std::abs(above - below) > 0.05f || std::abs(leaning) < 0.02f) continue;
            if (std::abs(map.pixel(x, y - 1)[1] - map.pixel(x, y + 1)[1]) > 0.02f) continue;
            EXPECT_EQ(leaning > 0, below > above) << x << ' ' << y;
            ++checked;
        }
    EXPECT_GT(checked, 256 * 256 / 4);
}

}  // namespace
}  // namespace relief
