// The drawing of lines on pixels of a tile.
#include "labs/07_baking/line_drawing.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "framework/library/kit/drawn_numbers.h"

namespace relief {
namespace {

TEST(LineDrawing, FillsTheMiddleOfItsTileAndKeepsTheProportions) {
    LineDrawing drawing;
    glDisable(GL_DEPTH_TEST);  // another test may have left it on
    const auto covered = [&](const std::vector<DrawnLine>& lines) {
        const Image picture = draw_numbers({100, 50}, [&] { drawing.draw({{50, 0}, {50, 50}}, lines); });
        glm::ivec2 low(100), high(-1);
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 100; ++x)
                if (picture.pixel(x, y)[0] == 0.25f) low = glm::min(low, {x, y}), high = glm::max(high, {x, y});
        return std::pair(low, high);
    };
    const glm::vec3 color(0.25f, 1, 1);
    // A square of 84 % of the tile's 50 pixels: from 4 to 46, with lines 20 times as wide as usual, 20 pixels.
    const auto [low, high] = covered({{{-3, 5}, {7, 5}, color, 20}, {{-3, 15}, {7, 15}, color, 20}});
    EXPECT_EQ(low, glm::ivec2(54, 0)) << "half of a line is above the square, and cut off";
    EXPECT_EQ(high, glm::ivec2(95, 49));
    EXPECT_EQ(covered({{{1, 1}, {1, 1}, color, 1}}).second, glm::ivec2(-1)) << "without length";
    EXPECT_EQ(covered({}).second, glm::ivec2(-1));
    EXPECT_FALSE(glIsEnabled(GL_DEPTH_TEST)) << "as before";
}

}  // namespace
}  // namespace relief
