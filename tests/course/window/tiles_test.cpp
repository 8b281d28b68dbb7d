// The mean error of each tile, beside a lab's picture, and the rows of the start page.
#include "framework/course/window/menu_tiles.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

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

TEST(Tiles, AreThoseOfAnyCaption) {
    Image error(2, 1, 1);
    error.values = {1, 3};
    EXPECT_EQ(tile_means({caption(0, 0.5f), caption(0.5f, 0.5f, -1)}, error).size(), 2u) << "the second has no title";
}

TEST(Tiles, OfAWholePictureAreNone) {
    Image error(2, 1, 1);
    EXPECT_TRUE(tile_means({caption(0, 1)}, error).empty());
    EXPECT_TRUE(tile_means({}, error).empty());
}

TEST(Tiles, ValuesBesideAPixelHideNoNumberOfATile) {
    const Box room{{0, 0}, {400, 300}};
    const glm::ivec2 pixel(200, 150), size(60, 40);
    EXPECT_EQ(beside(pixel, size, room, {}), pixel + 16);
    const Box below_right{{240, 180}, {30, 12}}, below_left{{130, 180}, {30, 12}};
    EXPECT_EQ(beside(pixel, size, room, {below_right}), glm::ivec2(200 - 16 - 60, 166));
    EXPECT_EQ(beside(pixel, size, room, {below_right, below_left}), glm::ivec2(216, 150 - 16 - 40));
    // In a corner, and where nothing is free.
    EXPECT_EQ(beside({390, 290}, size, room, {}), glm::ivec2(390 - 76, 290 - 56));
    EXPECT_EQ(beside(pixel, size, room, {room}), pixel + 16);
    EXPECT_EQ(beside(pixel, {500, 40}, room, {}).x, 0);
}

TEST(Rows, HoldAllCardsAndNoneAloneBelowOthersInThreeColumnsOrMore) {
    for (size_t columns = 1; columns < 9; ++columns)
        for (size_t count = 0; count < 30; ++count) {
            const std::vector<size_t> rows = even_rows(count, columns);
            EXPECT_EQ(std::accumulate(rows.begin(), rows.end(), size_t{0}), count);
            EXPECT_EQ(rows.size(), (count + columns - 1) / columns) << "no more rows than needed";
            for (const size_t row : rows) {
                EXPECT_LE(row, columns);
                if (columns > 2 && rows.size() > 1) {
                    EXPECT_GT(row, 1u) << count << " in " << columns;
                }
            }
        }
}

}  // namespace
}  // namespace relief::window
