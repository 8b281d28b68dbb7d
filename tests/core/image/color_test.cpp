// The sRGB curve against IEC 61966-2-1, and its fast forms against the formula.
#include "framework/core/image/color.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace relief {
namespace {

/// Returns the result that srgb8_from_linear() promises, by the formula.
int rounded(float light) { return int(std::lround(std::clamp(255 * srgb_from_linear(double(light)), 0.0, 255.0))); }

TEST(Srgb, MatchesTheStandardsFormula) {
    // Evaluated from the standard's formula with 40 digits; 3e-16 allows for one or two roundings near 1.
    EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114048223244243, 3e-16);
    EXPECT_NEAR(linear_from_srgb(0.75), 0.52252155396839181772, 3e-16);
    EXPECT_NEAR(linear_from_srgb(0.04045), 0.0031308049535603715170, 1e-18) << "the end of the straight part";
    EXPECT_NEAR(srgb_from_linear(0.0031308), 0.040449936, 1e-17) << "the end of the straight part";
    EXPECT_NEAR(srgb_from_linear(0.18), 0.46135612950044164986, 3e-16);
    EXPECT_NEAR(srgb_from_linear(0.5), 0.73535698305244949062, 3e-16);
    for (const double end : {0.0, 1.0}) {
        EXPECT_DOUBLE_EQ(srgb_from_linear(end), end);
        EXPECT_DOUBLE_EQ(linear_from_srgb(end), end);
    }
}

TEST(Srgb, TheTwoCurvesAreInverseAlsoBeyondOneAndBelowZero) {
    for (int i = -2000; i <= 2000; ++i) {
        const double value = i / 1000.0;
        // The standard's two parts meet within 3e-8; elsewhere only rounding contributes.
        EXPECT_NEAR(linear_from_srgb(srgb_from_linear(value)), value, 2e-15) << value;
        EXPECT_NEAR(srgb_from_linear(linear_from_srgb(value)), value, 2e-15) << value;
        EXPECT_EQ(srgb_from_linear(-value), -srgb_from_linear(value)) << value;
    }
}

TEST(Srgb8, RoundTripsEveryStoredValue) {
    for (int i = 0; i < 256; ++i) {
        EXPECT_EQ(srgb8_from_linear(linear_from_srgb8(static_cast<unsigned char>(i))), i);
        EXPECT_EQ(linear_from_srgb8(static_cast<unsigned char>(i)), float(linear_from_srgb(i / 255.0))) << i;
    }
    EXPECT_FLOAT_EQ(linear_from_srgb8(128), 0.21586050f);
}

TEST(Srgb8, RoundsLikeTheFormulaEverywhere) {
    const unsigned seed = 1;
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> light(-0.1f, 1.1f), dark(0, 0.01f);
    for (int i = 0; i < 50000; ++i)
        for (const float value : {light(random), dark(random)})
            ASSERT_EQ(srgb8_from_linear(value), rounded(value)) << value << ", seed " << seed;
}

TEST(Srgb8, RoundsLikeTheFormulaHalfWayBetweenStoredValues) {
    for (int i = 0; i < 255; ++i) {
        float value = float(linear_from_srgb((i + 0.5) / 255));
        for (int k = 0; k < 3; ++k) value = std::nextafter(value, 0.0f);
        for (int k = -3; k <= 3; ++k, value = std::nextafter(value, 1.0f))
            EXPECT_EQ(srgb8_from_linear(value), rounded(value)) << i << " and a half, " << k << " floats off";
    }
}

TEST(Srgb8, IsClamped) {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float low : {-1e-30f, -1.0f, -infinity}) EXPECT_EQ(srgb8_from_linear(low), 0) << low;
    for (const float high : {1.0f, 1.0001f, 1e30f, infinity}) EXPECT_EQ(srgb8_from_linear(high), 255) << high;
}

}  // namespace
}  // namespace relief
