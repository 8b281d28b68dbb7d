// Numbers as colours: invalid values and the background stand out.
#include "framework/library/maps/visualize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "framework/core/image/color.h"

namespace relief {
namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
using Color = std::array<float, 3>;

Color probe_color(const std::vector<float>& value, ProbeColors metric) {
    Image probe(2, 1, int(value.size()));  // the second pixel is 0
    std::copy(value.begin(), value.end(), probe.values.begin());
    const Image picture = visualize_probe(probe, metric);
    return {picture.values.at(0), picture.values.at(1), picture.values.at(2)};
}

Color error_color(float error, double largest) {
    Image image(1, 1, 1);
    image.values[0] = error;
    const Image picture = visualize_error(image, largest);
    return {picture.values.at(0), picture.values.at(1), picture.values.at(2)};
}

/// Relative luminance (ITU-R BT.709) of a stored colour.
double luminance(const Color& color) {
    return 0.2126 * linear_from_srgb(color[0]) + 0.7152 * linear_from_srgb(color[1]) +
           0.0722 * linear_from_srgb(color[2]);
}

TEST(Visualize, ANanIsMagentaInAnyChannel) {
    const Color magenta{1, 0, 1};
    for (const ErrorMetric metric : {ErrorMetric::distance, ErrorMetric::angle, ErrorMetric::absolute}) {
        EXPECT_EQ(probe_color({not_a_number, 0, 0}, metric), magenta);
        EXPECT_EQ(probe_color({0, 0, not_a_number, 0}, metric), magenta);
    }
    EXPECT_EQ(probe_color({not_a_number}, ErrorMetric::absolute), magenta);
    EXPECT_EQ(error_color(not_a_number, 1), magenta);
}

TEST(Visualize, AMissingTaskIsMagentaAsInThePicture) {
    const Color magenta{0.85f, 0, 0.85f};  // as in unfinished.glsl
    for (const ErrorMetric metric : {ErrorMetric::distance, ErrorMetric::angle, ErrorMetric::absolute})
        EXPECT_EQ(probe_color(std::vector<float>(4, not_written), metric), magenta);
    EXPECT_EQ(error_color(not_written, 1), magenta);
}

TEST(Visualize, NoSurfaceIsDarkGrey) {
    const Color probe = probe_color({no_surface, no_surface, no_surface, no_surface}, ErrorMetric::angle);
    EXPECT_EQ(error_color(no_surface, 1), probe);
    EXPECT_LT(luminance(probe), 0.02);
    for (const float channel : probe) EXPECT_NEAR(channel, 0.125f, 0.02f);
}

TEST(Visualize, APicturesValuesMayBeAnything) {
    const std::vector<float> strange = {not_a_number, INFINITY, -INFINITY, 1e38f, -1e38f, 1e-45f, 0.25f};
    for (const float a : strange)
        for (const float b : strange) {
            Image image(1, 1, 3);
            image.values = {a, b, 0.5f};
            const Color color = {visualize_picture(image).values[0], visualize_picture(image).values[1], 0.5f};
            const Color magenta{1, 0, 0.5f},
                grey = {error_color(no_surface, 1)[0], error_color(no_surface, 1)[1], 0.5f};
            EXPECT_EQ(color, std::isnan(a) || std::isnan(b) ? magenta
                             : std::isinf(a) || std::isinf(b)
                                 ? grey
                                 : (Color{std::clamp(a, 0.0f, 1.0f), std::clamp(b, 0.0f, 1.0f), 0.5f}));
            for (const ErrorMetric metric : {ErrorMetric::distance, ErrorMetric::angle, ErrorMetric::absolute})
                for (const bool is_signed : {false, true})
                    for (const float channel : probe_color({a, b, 0.5f}, {metric, is_signed}))
                        EXPECT_TRUE(channel >= 0 && channel <= 1);
        }
}

TEST(Visualize, DirectionsLookLikeANormalMap) {
    EXPECT_EQ(probe_color({0, 0, 1, 0}, ErrorMetric::angle), (Color{0.5f, 0.5f, 1}));
    EXPECT_EQ(probe_color({-1, 1, 0}, ErrorMetric::angle), (Color{0, 1, 0.5f}));
}

TEST(Visualize, SingleNumbersAreHeatScaledByTheLargest) {
    EXPECT_EQ(probe_color({-8}, ErrorMetric::absolute), error_color(1, 1)) << "the largest size is the last colour";
    EXPECT_EQ(probe_color({0}, ErrorMetric::absolute), error_color(0, 1)) << "nothing to scale by";
}

/// Returns the shades of a vector's first channel. The second channel is 0, and the third is twice the first.
std::vector<float> shades(const std::vector<float>& values, bool is_signed = false) {
    Image probe(int(values.size()), 1, 3);
    for (size_t i = 0; i < values.size(); ++i) probe.values[3 * i] = values[i], probe.values[3 * i + 2] = 2 * values[i];
    const Image picture = visualize_probe(probe, {ErrorMetric::distance, is_signed});
    std::vector<float> shades;
    for (size_t i = 0; i < values.size(); ++i) shades.push_back(picture.values[3 * i]);
    return shades;
}
using Shades = std::vector<float>;

// The usual size of 2, 4 and 8 is 4, so L = 2. Half the usual size becomes 0.5 (1 + 0.5 / 4) / 1.5 = 0.375, the usual
// size 1.25 / 2, and the maximum 1.
TEST(Visualize, EachChannelOfAVectorSpansItsMinimumToItsMaximum) {
    EXPECT_EQ(shades({0, 2, 4, 8}), (Shades{0, 0.375f, 0.625f, 1}));
    EXPECT_EQ(shades({2, 4, 4, 8}), (Shades{0, 0.4f, 0.4f, 1})) << "0.375 is black";
    EXPECT_GT(shades({4, 4, 4.001f}).front(), 0.999f) << "all but constant: rounding is not stretched";
    EXPECT_EQ(shades({0, 0, 0}), (Shades{0, 0, 0}));
    const Shades below = shades({-2, 0, 4, 8});
    EXPECT_EQ(below.front(), 0);
    EXPECT_FLOAT_EQ(below[1], 0.375f / 1.375f);
    EXPECT_FLOAT_EQ(below[2], 1 / 1.375f);
}

TEST(Visualize, ASignedVectorIsBrighterThanHalfAbove0AndDarkerBelow) {
    EXPECT_EQ(shades({0, 2, -4, 8}, true), (Shades{0.5f, 0.6875f, 0.1875f, 1}));
    EXPECT_EQ(shades({0, -2, 4, -8}, true), (Shades{0.5f, 0.3125f, 0.8125f, 0})) << "the signs flipped";
    EXPECT_EQ(shades({0, 0, 0}, true), (Shades{0.5f, 0.5f, 0.5f}));
}

TEST(Visualize, ValuesThatDifferByRoundingLookTheSame) {
    for (const bool is_signed : {false, true})
        for (const float value : {1.0f, -1.0f, 0.5f, 3.0f, 0.03125f, 0.0f}) {
            const Shades around =
                shades({std::nextafter(value, -4.0f), value, std::nextafter(value, 4.0f), 4}, is_signed);
            for (size_t i = 0; i < 3; ++i) EXPECT_NEAR(around[i], around[1], 1e-5) << value;
        }
    Image probe(2, 1, 3);
    probe.values = {1e-9f, -1e-9f, 1, -1e-9f, 1e-9f, 2};
    for (const bool is_signed : {false, true}) {
        const Image picture = visualize_probe(probe, {ErrorMetric::distance, is_signed});
        // 1e-9 of 1e-5, the smallest size that is shown, for either of both.
        for (int c = 0; c < 2; ++c)
            EXPECT_NEAR(picture.values[size_t(c)], picture.values[size_t(c) + 3], 3e-4)
                << "beside a channel that is not";
    }
}

TEST(Visualize, AnOutlierKeepsTheContrastOfTheOtherValues) {
    const Shades shown = shades({0, 1, 2, 1e4f});
    EXPECT_NEAR(shown[1], 1.0 / 3, 1e-4) << "x / (1 + x), as L is large";
    EXPECT_NEAR(shown[2], 0.5, 1e-4);
    Image numbers(3, 1, 1);
    numbers.values = {1, 2, 1e4f};
    const Image picture = visualize_probe(numbers, ErrorMetric::absolute);
    EXPECT_GT(picture.values[3] - picture.values[0], 0.1);
}

TEST(Visualize, TheExpectedPictureHasContrastForAnyDrawnPicture) {
    Image drawn(4, 1, 1), expected = drawn;
    drawn.values.assign(4, 1e4f), expected.values = {0, 1, 2, 3};
    for (const ErrorMetric metric : {ErrorMetric::distance, ErrorMetric::absolute}) {
        const auto [one, other] = visualize_probes(drawn, expected, metric);
        EXPECT_GT(other.values[9] - other.values[0], 0.5);
        EXPECT_GT(one.values[0], other.values[9]) << "in the same colours";
    }
}

TEST(Visualize, ASignedNumberIsBlueBelow0AndAsBrightAsItsOpposite) {
    const ProbeColors with_sign(ErrorMetric::absolute, true);
    EXPECT_EQ(probe_color({8}, with_sign), error_color(1, 1)) << "above 0 as without a sign";
    const Color below = probe_color({-8}, with_sign);
    EXPECT_GT(below[2], below[0]);
    EXPECT_GT(luminance(below), 0.7);
    EXPECT_EQ(probe_color({-0.0f}, with_sign), error_color(0, 1));
    const Image half = [] {
        Image image(2, 1, 1);
        image.values = {-4, 8};
        return visualize_probe(image, ProbeColors(ErrorMetric::absolute, true));
    }();
    EXPECT_GT(half.values[2], 1.5f * half.values[0]);
    EXPECT_LT(luminance({half.values[0], half.values[1], half.values[2]}), luminance(below)) << "one scale for both";
}

TEST(Visualize, ThePictureHasEightBitsAndThreeChannels) {
    const Image probe = visualize_probe(Image(3, 2, 4), ErrorMetric::distance),
                error = visualize_error(Image(3, 2, 1), 1);
    for (const Image* picture : {&probe, &error}) {
        EXPECT_EQ(picture->bits, 8);
        EXPECT_TRUE(picture->same_shape(Image(3, 2, 3)));
        for (const float value : picture->values) EXPECT_TRUE(value >= 0 && value <= 1) << value;
    }
}

TEST(HeatScale, GetsLighterWithEveryStep) {
    double before = -1;
    for (int i = 0; i <= 256; ++i) {
        const double now = luminance(error_color(float(i) / 256 * 3, 3));
        EXPECT_GT(now, before) << i << " of 256";
        before = now;
    }
    EXPECT_LT(luminance(error_color(0, 3)), 0.01) << "no error is black";
    EXPECT_GT(before, 0.9) << "the largest error is pale";
}

TEST(HeatScale, EndsAtTheLargestAndSurvivesAnEmptyScale) {
    EXPECT_EQ(error_color(7, 3), error_color(3, 3));
    EXPECT_EQ(error_color(5, 0), error_color(0, 3));
}

}  // namespace
}  // namespace relief
