// Height maps from formulas: the properties that every search relies on.
#include "framework/library/maps/test_maps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace relief {
namespace {

TEST(HeightMaps, SpanZeroToOneAndTile) {
    for (const HeightMap map :
         {HeightMap::smooth, HeightMap::fbm, HeightMap::bricks, HeightMap::stones, HeightMap::posts, HeightMap::rock}) {
        const Image image = make_height_map(map, 128);
        const auto [low, high] = std::minmax_element(image.values.begin(), image.values.end());
        EXPECT_EQ(*low, 0) << height_map_names[size_t(map)];
        EXPECT_NEAR(*high, 1, 1e-6) << height_map_names[size_t(map)];
        // The largest step across the border is no larger than the largest one inside.
        float inside = 0, border = 0;
        for (int y = 0; y < 128; ++y)
            for (int x = 0; x < 128; ++x) {
                const float step = std::abs(*image.pixel(x, y) - *image.pixel((x + 1) % 128, y));
                (x == 127 ? border : inside) = std::max(x == 127 ? border : inside, step);
            }
        EXPECT_LE(border, inside * 1.01f) << height_map_names[size_t(map)];
    }
}

TEST(HeightMaps, AreGeneratedAtAnySize) {
    for (size_t map = 0; map < height_map_names.size(); ++map)
        for (const int size : {1, 2, 3, 17}) {
            Image image = make_height_map(HeightMap(map), size);
            mend_heights(image);
            ASSERT_EQ(image.values.size(), size_t(size * size));
            for (const float height : image.values)
                ASSERT_TRUE(height >= 0 && height <= 1) << height_map_names[map] << ", " << size;
        }
}

TEST(HeightMaps, RepairDamagedTexels) {
    Image image = make_height_map(HeightMap::damaged, 64);
    const auto bad = [](float height) { return !(height >= 0 && height <= 1); };
    EXPECT_EQ(std::count_if(image.values.begin(), image.values.end(), bad), 5);
    mend_heights(image);
    EXPECT_EQ(std::count_if(image.values.begin(), image.values.end(), bad), 0);
}

}  // namespace
}  // namespace relief
