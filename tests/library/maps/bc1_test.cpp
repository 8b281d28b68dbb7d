#include "framework/library/maps/bc1.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace relief {
namespace {

Image filled(int width, int height, const std::function<glm::vec3(int x, int y)>& color) {
    Image image(width, height, 3);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.pixel(x, y)[c] = color(x, y)[c];
    return image;
}

double largest_error(const Image& a, const Image& b) {
    double largest = 0;
    for (size_t i = 0; i < a.values.size(); ++i)
        largest = std::max(largest, std::abs(double(a.values[i]) - b.values[i]));
    return largest;
}

TEST(Bc1, KeepsOneColorToThePrecisionOfItsEnds) {
    // 5, 6 and 5 bits: half a step is 1/62 or 1/126.
    const Image one = filled(8, 4, [](int, int) { return glm::vec3(0.31f, 0.47f, 0.86f); });
    const Image back = through_bc1(one);
    EXPECT_LE(std::abs(back.values[0] - 0.31f), 1 / 62.0 + 1 / 510.0);
    EXPECT_LE(std::abs(back.values[1] - 0.47f), 1 / 126.0 + 1 / 510.0);
    EXPECT_LE(std::abs(back.values[2] - 0.86f), 1 / 62.0 + 1 / 510.0);
}

TEST(Bc1, KeepsTwoEndsAndTheThirdsBetweenThemExactly) {
    const Image grey = filled(4, 4, [](int x, int) { return glm::vec3(float(85 * x) / 255); });
    EXPECT_LE(largest_error(through_bc1(grey), grey), 1e-6);
    const Image two = filled(4, 4, [](int x, int y) { return (x + y) % 2 ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0); });
    EXPECT_LE(largest_error(through_bc1(two), two), 1e-6);
}

TEST(Bc1, CannotKeepTwoIndependentChannels) {
    const Image corners = filled(4, 4, [](int x, int y) { return glm::vec3(x % 2, y % 2, 0); });
    EXPECT_GT(largest_error(through_bc1(corners), corners), 0.3) << "the 4 colors of a block are on one line";
}

TEST(Bc1, BlocksMixNoTexelsAcrossTheirBorders) {
    // Blocks begin at the lower left corner. The last ones of a map of 6 x 5 texels repeat its border.
    Image map = filled(6, 5, [](int x, int y) { return glm::vec3(x / 5.0f, y / 4.0f, 0.5f); });
    const Image before = through_bc1(map);
    for (int y = 0; y < 5; ++y) map.pixel(0, y)[0] = 1;
    const Image after = through_bc1(map);
    for (int y = 0; y < 5; ++y)
        for (int x = 4; x < 6; ++x)
            for (int c = 0; c < 3; ++c) EXPECT_EQ(after.pixel(x, y)[c], before.pixel(x, y)[c]) << x << ", " << y;
}

TEST(Bc1, CountsNaNAsZero) {
    Image map = filled(4, 4, [](int, int) { return glm::vec3(0); });
    map.values[5] = std::numeric_limits<float>::quiet_NaN();
    for (const float value : through_bc1(map).values) EXPECT_EQ(value, 0);
}

}  // namespace
}  // namespace relief
