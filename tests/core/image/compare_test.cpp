// Differences between pictures, and errors of probes against their truth.
#include "framework/core/image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "tests/support.h"

namespace relief {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

Image row(int channels, std::vector<float> values) {
    Image image(int(values.size()) / channels, 1, channels);
    image.values = std::move(values);
    return image;
}

float error_of(const std::vector<float>& measured, const std::vector<float>& truth, ErrorMetric metric) {
    const int channels = int(measured.size());
    return error_image(row(channels, measured), row(channels, truth), metric).values.at(0);
}

TEST(OneColor, ComparesPixelsNotChannels) {
    EXPECT_TRUE(is_one_color(row(3, {0.1f, 0.2f, 0.3f, 0.1f, 0.2f, 0.3f})));
    EXPECT_FALSE(is_one_color(row(3, {0.1f, 0.2f, 0.3f, 0.1f, 0.2f, 0.30001f})));
    EXPECT_TRUE(is_one_color(row(4, {inf, inf, inf, inf, inf, inf, inf, inf}))) << "a probe that hit nothing";
    EXPECT_TRUE(is_one_color(row(1, {nan, nan}))) << "a broken picture is no better than a blank one";
    EXPECT_TRUE(is_one_color(row(3, {1, 2, 3})));
    EXPECT_TRUE(is_one_color(Image()));
}

TEST(Difference, CountsPixelsWithAChannelOverTheThreshold) {
    const Image a = row(2, {0, 0, 0, 0, 0, 0}), b = row(2, {0.5f, 0.75f, 0, 0, 0.25f, 0});
    const Difference found = difference(a, b, 0.25);
    EXPECT_EQ(found.largest, 0.75);
    EXPECT_EQ(found.pixels_over, 1u) << "a pixel off by exactly the threshold is not over it";
    EXPECT_EQ(difference(b, a, 0.0).pixels_over, 2u);
    EXPECT_EQ(difference(a, a, 0.0).largest, 0.0);
}

TEST(Difference, IsInfiniteToANanAndZeroBetweenEqualInfinities) {
    for (const auto& [x, y] : {std::pair(nan, 0.0f), {0.0f, nan}, {nan, nan}, {inf, 0.0f}, {inf, -inf}, {inf, nan}}) {
        const Difference found = difference(row(1, {x, 0}), row(1, {y, 0}), 1e30);
        EXPECT_EQ(found.largest, INFINITY) << x << ", " << y;
        EXPECT_EQ(found.pixels_over, 1u) << x << ", " << y;
    }
    EXPECT_EQ(difference(row(1, {inf, -inf}), row(1, {inf, -inf}), 0).largest, 0);
}

TEST(Difference, IsInfiniteAtAllPixelsForDifferentShapes) {
    for (const Image& other : {Image(3, 2, 3), Image(2, 3, 3), Image(2, 2, 4), Image()}) {
        const Difference found = difference(Image(2, 2, 3), other, 1e30);
        EXPECT_EQ(found.largest, INFINITY);
        EXPECT_EQ(found.pixels_over, std::max<size_t>(4, other.pixel_count()));
    }
}

TEST(Error, IsTheDistanceOverAllChannelsOrTheFirstAlone) {
    EXPECT_EQ(error_of({1, 2, 3, 4}, {1, 5, 3, 8}, ErrorMetric::distance), 5);  // differences 3 and 4
    EXPECT_EQ(error_of({1, 9, 9}, {3, 0, 0}, ErrorMetric::absolute), 2);
    EXPECT_EQ(error_of({3}, {1}, ErrorMetric::distance), 2);
}

TEST(Error, IsExactForAnglesFromAMillionthOfADegreeTo180) {
    // With acos of the dot product, angles below 0.014 degrees would be lost in float, and below 6e-7 in double.
    for (const double degrees : {0.0, 1e-6, 1e-5, 1e-3, 0.02, 1.0, 45.0, 90.0, 135.0, 179.0, 180.0}) {
        const double angle = degrees * M_PI / 180;
        // In a plane where the small component keeps all its digits: (1, 0, 0) against (cos, sin, 0).
        const float x = float(std::cos(angle)), y = float(std::sin(angle));
        EXPECT_NEAR(error_of({1, 0, 0}, {x, y, 0}, ErrorMetric::angle), degrees, 2e-7 * degrees + 1e-12);
        EXPECT_NEAR(error_of({0, y, x, 0.3f}, {0, 0, 2, 0.9f}, ErrorMetric::angle), degrees, 2e-7 * degrees + 1e-12)
            << "neither the length nor a fourth channel counts";
    }
    EXPECT_FLOAT_EQ(error_of({1, 2, 3}, {-1, -2, -3}, ErrorMetric::angle), 180);
}

TEST(Error, OfAcosIs0Below0014DegreesAndThen002) {
    // 1 - angle^2 / 2 rounds to 1 where angle^2 / 2 < 2^-25. The next float below 1 is 1 - 2^-24.
    const auto by_acos = [](double degrees) {
        return double(std::acos(float(std::cos(degrees * M_PI / 180)))) * 180 / M_PI;
    };
    EXPECT_EQ(by_acos(0.01398), 0);
    EXPECT_NEAR(by_acos(0.014), 0.02, 0.0003);
}

TEST(Error, IsNanForAVectorWithoutDirection) {
    EXPECT_TRUE(std::isnan(error_of({0, 0, 0}, {0, 0, 1}, ErrorMetric::angle))) << "not an angle of 0: that would pass";
    EXPECT_TRUE(std::isnan(error_of({0, 0, 1}, {0, 0, 0}, ErrorMetric::angle)));
}

TEST(Error, IsInfiniteWithoutASurfaceAndNanWhereEitherIs) {
    for (const ErrorMetric metric : {ErrorMetric::distance, ErrorMetric::angle, ErrorMetric::absolute}) {
        EXPECT_EQ(error_of({inf, inf, inf}, {0, 0, 1}, metric), inf) << int(metric);
        EXPECT_EQ(error_of({0, 0, 1}, {inf, inf, inf}, metric), inf) << int(metric);
        EXPECT_EQ(error_of({inf, inf, inf}, {inf, inf, inf}, metric), inf) << int(metric);
        EXPECT_TRUE(std::isnan(error_of({nan, 0, 1}, {0, 0, 1}, metric))) << int(metric);
        EXPECT_TRUE(std::isnan(error_of({0, 0, 1}, {nan, nan, nan}, metric))) << int(metric);
    }
    for (const ErrorMetric metric : {ErrorMetric::distance, ErrorMetric::angle, ErrorMetric::absolute})
        EXPECT_EQ(error_of({not_written, not_written, not_written}, {0, 0, 1}, metric), not_written) << int(metric);
    EXPECT_TRUE(std::isnan(error_of({0, nan, 1}, {0, 0, 1}, ErrorMetric::distance)));
    EXPECT_TRUE(std::isnan(error_of({0, nan, 1}, {0, 0, 1}, ErrorMetric::angle)));
}

TEST(Error, NeedsEqualShapesAndThreeChannelsForAnAngle) {
    EXPECT_TRUE(
        contains(message_of([] { error_image(Image(2, 1, 3), Image(1, 2, 3), ErrorMetric::distance); }), "same size"));
    EXPECT_TRUE(contains(message_of([] { error_image(Image(1, 1, 2), Image(1, 1, 2), ErrorMetric::angle); }),
                         "three channels"));
}

TEST(Summary, IsCorrectForTheNumbersOneToAHundred) {
    std::vector<float> values(100);
    std::iota(values.begin(), values.end(), 1.0f);
    std::shuffle(values.begin(), values.end(), std::mt19937(5));
    const ErrorSummary summary = summarize(row(1, values));
    EXPECT_EQ(summary.count, 100u);
    EXPECT_DOUBLE_EQ(summary.mean, 50.5);
    EXPECT_DOUBLE_EQ(summary.rms,
                     std::sqrt(101 * 201 / 6.0));  // the sum of squares is n (n + 1) (2 n + 1) / 6
    EXPECT_EQ(summary.p99, 99) << "99 of 100 do not exceed it";
    EXPECT_EQ(summary.largest, 100);
    EXPECT_EQ(summary.not_finite, 0u);
}

TEST(Summary, P99IsTheSmallestValueThat99PercentDoNotExceed) {
    for (int n = 1; n <= 1000; ++n) {
        std::vector<float> values(static_cast<size_t>(n));
        std::iota(values.rbegin(), values.rend(), 1.0f);
        const int rank = (99 * n + 99) / 100;  // ceil(0.99 n), in integers
        ASSERT_EQ(summarize(row(1, values)).p99, rank) << n << " pixels";
    }
}

TEST(Summary, SkipsPixelsWithoutASurfaceAndCountsNans) {
    const ErrorSummary summary = summarize(row(1, {inf, 2, nan, 4, inf, nan, not_written, nan, not_written}));
    EXPECT_EQ(summary.missing, 2u);
    EXPECT_EQ(summary.count, 2u);
    EXPECT_EQ(summary.mean, 3);
    EXPECT_EQ(summary.largest, 4);
    EXPECT_EQ(summary.not_finite, 3u);
    const ErrorSummary none = summarize(row(1, {inf, nan}));
    EXPECT_EQ(none.count, 0u);
    EXPECT_EQ(none.mean + none.rms + none.p99 + none.largest, 0);
    EXPECT_EQ(none.not_finite, 1u);
}

TEST(Summary, CountsPixelsWithASurfaceInOneOfTwoImagesAndMarksThem) {
    const Image measured = row(1, {1, 2, inf, inf, 3}), truth = row(1, {1, inf, 4, inf, inf});
    const OneSided found = one_sided(measured, truth);
    EXPECT_EQ(found.measured, 2u);
    EXPECT_EQ(found.truth, 1u);
    Image error = error_image(measured, truth, ErrorMetric::absolute);
    EXPECT_EQ(error.values, std::vector<float>({0, inf, inf, inf, inf}));
    mark_one_sided(error, measured, truth, 9);
    EXPECT_EQ(error.values, std::vector<float>({0, 9, 9, inf, 9}));
}

TEST(Summary, ReportsWhyNoPixelIsComparable) {
    const auto said = [](const Image& measured, const Image& truth) {
        return nothing_to_compare(measured, truth, summarize(error_image(measured, truth, ErrorMetric::absolute)));
    };
    EXPECT_EQ(said(row(1, {1, inf}), row(1, {2, 3})), "");
    EXPECT_EQ(said(row(1, {1, 2, inf}), row(1, {inf, inf, 3})),
              "no pixel can be compared: 2 have a surface only as it is drawn, 1 only in the expected values");
    EXPECT_EQ(said(row(1, {inf}), row(1, {inf})), "no pixel can be compared: there is no surface in the picture");
    EXPECT_EQ(said(row(1, {1, inf}), row(1, {nan, inf})),
              "no pixel can be compared: 1 are not a number or have no direction, as they are drawn or in the expected "
              "values");
    EXPECT_EQ(said(row(1, {not_written}), row(1, {1})), "1 pixels come from a task that is not written yet");
}

}  // namespace
}  // namespace relief
