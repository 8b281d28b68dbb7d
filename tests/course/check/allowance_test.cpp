// A check's allowance in a browser: a shift of less than a pixel, and nothing else.
#include "framework/course/check/allowance.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relief::check {
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
    EXPECT_LT(largest_error(without_shifts(shifted, expected, ErrorMetric::absolute, 1), expected), 0.05f);
}

TEST(Allowance, AnErrorOnSmoothGroundCountsInFull) {
    const Image expected = picture([](int, int) { return 1.0; }), wrong = picture([](int, int) { return 1.25; });
    EXPECT_EQ(without_shifts(wrong, expected, ErrorMetric::absolute, 1).values, wrong.values);
}

TEST(Allowance, BeyondTheNeighboursTheRestOfTheErrorCounts) {
    const Image expected = picture([](int x, int) { return x; }), wrong = picture([](int x, int) { return x + 3; });
    const Image left = without_shifts(wrong, expected, ErrorMetric::absolute, 1);
    EXPECT_EQ(*left.pixel(5, 5), 5 + 2);
}

TEST(Allowance, ASurfaceMayMoveByAPixelAtItsOutline) {
    const auto step = [](int edge) { return picture([=](int x, int) { return x < edge ? 0.5 : double(no_surface); }); };
    const Image expected = step(8);
    EXPECT_EQ(without_shifts(step(9), expected, ErrorMetric::absolute, 1).values, expected.values);
    EXPECT_EQ(without_shifts(step(7), expected, ErrorMetric::absolute, 1).values, expected.values);
    EXPECT_EQ(*without_shifts(step(10), expected, ErrorMetric::absolute, 1).pixel(9, 3), 0.5f);
}

TEST(Allowance, ValuesThatAreNoNumbersStay) {
    const Image expected = picture([](int x, int) { return x; });
    Image wrong = expected;
    *wrong.pixel(2, 2) = NAN;
    *wrong.pixel(3, 3) = not_written;
    const Image left = without_shifts(wrong, expected, ErrorMetric::absolute, 1);
    EXPECT_TRUE(std::isnan(*left.pixel(2, 2)));
    EXPECT_EQ(*left.pixel(3, 3), not_written);
}

TEST(Allowance, ADirectionKeepsItsLength) {
    Image expected(4, 4, 3);
    for (size_t i = 0; i < expected.values.size(); i += 3) expected.values[i + 2] = 1;
    Image twice = expected;
    for (float& value : twice.values) value *= 2;
    EXPECT_EQ(without_shifts(twice, expected, ErrorMetric::angle, 1).values, twice.values);
}

TEST(Allowance, TheLargestErrorsOfAShareOfThePixelsAreLeftOut) {
    const Image expected = picture([](int, int) { return 0.0; });  // 192 pixels
    const Image wrong = picture([](int x, int y) { return x == 3 && y < 5 ? 1 + y : 0; });
    const Image left = without_outliers(wrong, expected, ErrorMetric::absolute, 0.016);  // 3 pixels
    EXPECT_EQ(*left.pixel(3, 4), 0);
    EXPECT_EQ(*left.pixel(3, 2), 0);
    EXPECT_EQ(*left.pixel(3, 1), 2);
}

TEST(Allowance, AShiftIsAllowedUpToAShareOfAPixel) {
    const Image expected = picture([](int x, int) { return x; }),
                shifted = picture([](int x, int) { return x + 0.75; });
    EXPECT_EQ(*without_shifts(shifted, expected, ErrorMetric::absolute, 0.5f).pixel(5, 5), 5.25f);
}

TEST(Allowance, DependsOnTheRenderer) {
    EXPECT_EQ(rasteriser_of("ANGLE (Mesa/X.org, llvmpipe (LLVM 15.0.6 256 bits), OpenGL 4.5)"), Rasteriser::exact);
    EXPECT_EQ(rasteriser_of("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device (Subzero)))"), Rasteriser::coarse);
    EXPECT_EQ(rasteriser_of("ANGLE (Intel, Mesa Intel(R) UHD Graphics 620)"), Rasteriser::usual);
    const Image expected = picture([](int x, int) { return x; }), moved = picture([](int x, int) { return x + 0.75; });
    CheckInfo check;
    const auto left = [&](Rasteriser rasteriser) {
        return *with_allowance(rasteriser, check, ErrorMetric::absolute, moved, expected).pixel(5, 5);
    };
    EXPECT_EQ(left(Rasteriser::exact), 5.75f);
    EXPECT_EQ(left(Rasteriser::usual), 5.25f);
    EXPECT_EQ(left(Rasteriser::coarse), 5.625f);
    check.limits.at_least = 0.5;  // the two must differ
    EXPECT_EQ(left(Rasteriser::coarse), 5.75f);
}

TEST(Allowance, WhatMovesWithTheVerticesIsAllowedOnBothSides) {
    const auto flat = [](double value) { return picture([=](int, int) { return value; }); };
    const std::vector<Image> moved = {flat(5), flat(6)};  // the range is 1, and a quarter more on either side
    const auto left = [&](double expected) {
        return *without_rounding(flat(5.5), moved, flat(expected), ErrorMetric::absolute).pixel(5, 5);
    };
    EXPECT_EQ(left(4.75), 4.75f);
    EXPECT_EQ(left(6.25), 6.25f);
    EXPECT_EQ(left(3), 4.75f);
    EXPECT_EQ(left(9), 6.25f);
    CheckInfo check;
    EXPECT_EQ(with_allowance(Rasteriser::coarse, check, ErrorMetric::absolute, flat(5.5), flat(6.25), moved).values,
              flat(6.25).values);
    EXPECT_EQ(with_allowance(Rasteriser::usual, check, ErrorMetric::absolute, flat(5.5), flat(7.5), moved).values,
              with_allowance(Rasteriser::usual, check, ErrorMetric::absolute, flat(5.5), flat(7.5)).values);
}

TEST(Allowance, AProbesOutlierMovesWithTheVertices) {
    const Image expected = picture([](int, int) { return 0; });
    const auto spot = [](double value) { return picture([=](int x, int y) { return x == 5 && y == 5 ? value : 0; }); };
    const auto left = [&](const CheckInfo& check, const Image& moved) {
        return *with_allowance(Rasteriser::coarse, check, ErrorMetric::absolute, spot(9), expected, {moved})
                    .pixel(5, 5);
    };
    CheckInfo of_picture, of_probe;
    of_probe.shot.probe.name = "height";
    EXPECT_EQ(left(of_probe, spot(9)), 9);
    EXPECT_EQ(left(of_probe, spot(8)), 0);
    EXPECT_EQ(left(of_picture, spot(9)), 0) << "the filters of another renderer also change what does not move";
}

TEST(Allowance, WhatStaysWhenVerticesMoveKeepsItsError) {
    const Image expected = picture([](int x, int y) { return x % 2 + y % 3; }),
                wrong = picture([](int x, int y) { return x % 2 + y % 3 + 0.01; });
    EXPECT_EQ(without_rounding(wrong, {wrong, wrong}, expected, ErrorMetric::absolute).values, wrong.values);
}

TEST(Allowance, ASurfaceInSomeOfTheMovedDrawingsIsAllowed) {
    const auto step = [](int edge) { return picture([=](int x, int) { return x < edge ? 0.5 : double(no_surface); }); };
    const auto left = [&](const std::vector<Image>& moved) {
        return without_rounding(step(9), moved, step(8), ErrorMetric::absolute);
    };
    EXPECT_EQ(left({step(8)}).values, step(8).values);
    EXPECT_EQ(left({step(9)}).values, step(9).values);
}

TEST(Allowance, ADirectionThatMovesKeepsItsLength) {
    const auto leaning = [](float x, float length) {
        Image image(1, 1, 3);
        image.values = {length * x, 0, length * std::sqrt(1 - x * x)};
        return image;
    };
    const Image left = without_rounding(leaning(0.6f, 2), {leaning(0.5f, 3)}, leaning(0.55f, 1), ErrorMetric::angle);
    EXPECT_FLOAT_EQ(left.values[0], 2 * 0.55f);
    EXPECT_FLOAT_EQ(left.values[2], 2 * std::sqrt(1 - 0.55f * 0.55f));
    const Image longer = leaning(0.6f, 3), drawn = leaning(0.6f, 2);
    EXPECT_NEAR(without_rounding(drawn, {longer}, leaning(0.55f, 1), ErrorMetric::angle).values[0], 1.2f, 1e-6f);
}

TEST(Allowance, ValuesThatAreNoNumbersStayWhenVerticesMove) {
    Image drawn(1, 1, 3), moved = drawn, expected = drawn;
    drawn.values = {NAN, not_written, 1};
    moved.values = {0, 0, NAN};
    const Image left = without_rounding(drawn, {moved}, expected, ErrorMetric::distance);
    EXPECT_TRUE(std::isnan(left.values[0]));
    EXPECT_EQ(left.values[1], not_written);
    EXPECT_EQ(left.values[2], 1);
}

}  // namespace
}  // namespace relief::check
