// The mean error of each tile, beside a lab's picture.
#include "framework/course/window/menu_tiles.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relief::window {
namespace {

PictureWord caption(float x, float width, int line = 0) {
    return {.kind = PictureWord::Kind::caption, .place = {x, 0}, .size = {width, 1}, .text = "tile", .line = line};
}

TEST(Tiles, HaveTheMeanOfTheirPixelsThatHaveASurface) {
    Image error(4, 1, 1);
    error.values = {1, 3, 5, INFINITY};
    const std::vector<TileMean> means =
        tile_means({caption(0, 0.5f), caption(0, 0.5f, -1), caption(0.5f, 0.5f)}, error);
    ASSERT_EQ(means.size(), 2u);
    EXPECT_EQ(means[0].mean, 2);
    EXPECT_EQ(means[1].mean, 5);
    EXPECT_EQ(means[1].place.x, 0.5f);
}

TEST(Tiles, OfAWholePictureAreNone) {
    Image error(2, 1, 1);
    EXPECT_TRUE(tile_means({caption(0, 1)}, error).empty());
    EXPECT_TRUE(tile_means({}, error).empty());
}

}  // namespace
}  // namespace relief::window
