// Bounds of a relief's regions: the surface never exceeds them, and they are no wider than necessary.
#include "framework/library/maps/bounds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "framework/staff/reference/height_field.h"

#include "framework/core/base/error.h"

namespace relief {
namespace {

constexpr unsigned bounds_seed = 5;

Image noise(int width, int height) {
    std::mt19937 random(bounds_seed);
    std::uniform_real_distribution<float> value(0, 1);
    Image image(width, height, 1);
    for (float& v : image.values) v = value(random);
    return image;
}

TEST(HeightBounds, ContainTheSurfaceOnEveryLevelOfMapsOfAnySize) {
    for (const auto& [width, height] :
         {std::pair(16, 16), {64, 4}, {5, 3}, {7, 1}, {1, 9}, {13, 13}, {31, 17}, {1, 1}}) {
        const Image heights = noise(width, height);
        const HeightField field(heights, true);
        const std::vector<Image> levels = min_max_mips(heights);
        std::mt19937 random(bounds_seed);
        std::uniform_real_distribution<> share(0, 1);
        for (int i = 0; i < 2000; ++i) {
            const glm::dvec2 at(share(random), share(random));  // in the map; cells begin at texel centres
            const double h = field.height(at * glm::dvec2(width, height) + 0.5);
            for (const Image& level : levels) {
                const float* const bounds =
                    level.pixel(int(at.x * level.width), level.height - 1 - int(at.y * level.height));
                // Bilinear interpolation rounds.
                ASSERT_LE(bounds[0], h + 1e-12) << width << "x" << height << ", level of " << level.width;
                ASSERT_GE(bounds[1], h - 1e-12) << width << "x" << height << ", level of " << level.width;
            }
        }
    }
}

TEST(HeightBounds, AreTheCornerExtremaIfTheSideIsAPowerOfTwo) {
    const Image heights = noise(16, 16);
    const std::vector<Image> levels = min_max_mips(heights);
    ASSERT_EQ(levels.size(), 5u);
    for (int k = 0; k < 5; ++k)
        for (int j = 0; j < 16 >> k; ++j)
            for (int i = 0; i < 16 >> k; ++i) {
                float low = 1, high = 0;
                for (int v = j << k; v <= (j + 1) << k; ++v)  // includes the far corners, also across the border
                    for (int u = i << k; u <= (i + 1) << k; ++u) {
                        const float h = *heights.pixel(u % 16, 15 - v % 16);
                        low = std::min(low, h), high = std::max(high, h);
                    }
                const float* const bounds = levels[size_t(k)].pixel(i, (16 >> k) - 1 - j);
                EXPECT_EQ(bounds[0], low) << k << ": " << i << ", " << j;
                EXPECT_EQ(bounds[1], high) << k << ": " << i << ", " << j;
            }
}

TEST(HeightBounds, HalveRoundedDownAsTextureLevelsDo) {
    const std::vector<Image> levels = min_max_mips(noise(12, 5));
    const int sizes[][2] = {{12, 5}, {6, 2}, {3, 1}, {1, 1}};
    ASSERT_EQ(levels.size(), std::size(sizes));
    for (size_t i = 0; i < levels.size(); ++i) {
        EXPECT_EQ(levels[i].width, sizes[i][0]);
        EXPECT_EQ(levels[i].height, sizes[i][1]);
    }
}

TEST(HeightBounds, HaveEqualMinimumAndMaximumWhereTheMapIsFlat) {
    Image heights(8, 8, 1);
    std::fill(heights.values.begin(), heights.values.end(), 0.25f);
    *heights.pixel(3, 3) = 1;  // column 3, row 4 from below: a corner of four cells
    const std::vector<Image> levels = min_max_mips(heights);
    int cells = 0;
    for (size_t i = 0; i < 64; ++i) cells += levels[0].values[2 * i] != levels[0].values[2 * i + 1];
    EXPECT_EQ(cells, 4);
    EXPECT_EQ(levels[1].pixel(3, 0)[0], levels[1].pixel(3, 0)[1]);
    EXPECT_EQ(levels.back().values, (std::vector<float>{0.25f, 1}));
}

TEST(HeightBounds, AreStoredSideBySideInAnAtlas) {
    for (const int side : {1, 2, 16}) {
        const Image heights = noise(side, side);
        const std::vector<Image> levels = min_max_mips(heights);
        const Image atlas = min_max_atlas(heights);
        EXPECT_EQ(atlas.width, side + side / 2);
        EXPECT_EQ(atlas.height, side);
        for (size_t k = 0; k < levels.size(); ++k)
            for (int y = 0; y < levels[k].height; ++y)
                for (int x = 0; x < levels[k].width; ++x) {
                    const int left = k == 0 ? 0 : side, up = k == 0 ? 0 : side - (side >> (k - 1));
                    const float* const here = atlas.pixel(left + x, side - 1 - (up + y));
                    const float* const level = levels[k].pixel(x, levels[k].height - 1 - y);
                    EXPECT_EQ(here[0], level[0]) << side << ", " << k;
                    EXPECT_EQ(here[1], level[1]) << side << ", " << k;
                }
    }
    EXPECT_THROW(min_max_atlas(noise(12, 5)), Error);
}

}  // namespace
}  // namespace relief
