// What a check in a browser allows: a shift of less than a pixel, and nothing else.
#include "framework/course/web/allowance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relief::web {
namespace {

/// A picture of one channel from a function of the place.
template <class Value>
Image picture(Value value) {
    Image image(16, 12, 1);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) *image.pixel(x, y) = float(value(x, y));
    return image;
}

/// Returns the largest error away from the border, where a shift shows what is outside of the picture.
float largest_error(const Image& drawn, const Image& expected) {
    float largest = 0;
    for (int y = 1; y + 1 < drawn.height; ++y)
        for (int x = 1; x + 1 < drawn.width; ++x)
            largest = std::max(largest, std::abs(*drawn.pixel(x, y) - *expected.pixel(x, y)));
    return largest;
}

TEST(Allowance, AShiftByHalfAPixelIsAllowed) {
    const auto wave = [](double x, double y) { return std::sin(0.7 * x) + 0.3 * y; };
    const Image expected = picture(wave), shifted = picture([&](int x, int y) { return wave(x + 0.4, y - 0.4); });
    EXPECT_GT(largest_error(shifted, expected), 0.3f);
    EXPECT_LT(largest_error(without_shifts(shifted, expected, ErrorMetric::absolute), expected), 0.05f);
}

TEST(Allowance, AnErrorOnSmoothGroundCountsInFull) {
    const Image expected = picture([](int, int) { return 1.0; }), wrong = picture([](int, int) { return 1.25; });
    EXPECT_EQ(without_shifts(wrong, expected, ErrorMetric::absolute).values, wrong.values);
}

TEST(Allowance, BeyondTheNeighboursTheRestOfTheErrorCounts) {
    const Image expected = picture([](int x, int) { return x; }), wrong = picture([](int x, int) { return x + 3; });
    const Image left = without_shifts(wrong, expected, ErrorMetric::absolute);
    EXPECT_EQ(*left.pixel(5, 5), 5 + 2);
}

TEST(Allowance, ASurfaceMayMoveByAPixelAtItsOutline) {
    const auto step = [](int edge) { return picture([=](int x, int) { return x < edge ? 0.5 : double(no_surface); }); };
    const Image expected = step(8);
    EXPECT_EQ(without_shifts(step(9), expected, ErrorMetric::absolute).values, expected.values);
    EXPECT_EQ(without_shifts(step(7), expected, ErrorMetric::absolute).values, expected.values);
    EXPECT_EQ(*without_shifts(step(10), expected, ErrorMetric::absolute).pixel(9, 3), 0.5f);
}

TEST(Allowance, ValuesThatAreNoNumbersStay) {
    const Image expected = picture([](int x, int) { return x; });
    Image wrong = expected;
    *wrong.pixel(2, 2) = NAN;
    *wrong.pixel(3, 3) = not_written;
    const Image left = without_shifts(wrong, expected, ErrorMetric::absolute);
    EXPECT_TRUE(std::isnan(*left.pixel(2, 2)));
    EXPECT_EQ(*left.pixel(3, 3), not_written);
}

TEST(Allowance, ADirectionKeepsItsLength) {
    Image expected(4, 4, 3);
    for (size_t i = 0; i < expected.values.size(); i += 3) expected.values[i + 2] = 1;
    Image twice = expected;
    for (float& value : twice.values) value *= 2;
    EXPECT_EQ(without_shifts(twice, expected, ErrorMetric::angle).values, twice.values);
}

TEST(Allowance, TheLargestErrorsOfAShareOfThePixelsAreLeftOut) {
    const Image expected = picture([](int, int) { return 0.0; });  // 192 pixels
    const Image wrong = picture([](int x, int y) { return x == 3 && y < 5 ? 1 + y : 0; });
    const Image left = without_outliers(wrong, expected, ErrorMetric::absolute, 0.016);  // 3 pixels
    EXPECT_EQ(*left.pixel(3, 4), 0);
    EXPECT_EQ(*left.pixel(3, 2), 0);
    EXPECT_EQ(*left.pixel(3, 1), 2);
}

}  // namespace
}  // namespace relief::web
