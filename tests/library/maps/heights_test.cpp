// Heights in pictures of the user: the channel, texels without a height, and metres.
#include "framework/library/maps/heights.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "tests/support.h"

namespace relief {
namespace {

constexpr int map_side = 24;

/// Returns a picture whose channels are functions of x and y.
Image picture(int channels, int bits, const std::function<float(int x, int y, int channel)>& value) {
    Image image(map_side, map_side, channels, bits);
    for (int y = 0; y < map_side; ++y)
        for (int x = 0; x < map_side; ++x)
            for (int c = 0; c < channels; ++c) image.pixel(x, y)[c] = value(x, y, c);
    return image;
}
float slope(int x, int) { return float(x) / (map_side - 1); }
float other_slope(int, int y) { return float(y) / (map_side - 1); }
Image slopes(int bits = 16) {
    return picture(1, bits, [](int x, int y, int) { return slope(x, y); });
}
/// Metres from 1047 to 1270.
Image mountains() {
    return picture(1, 32, [](int x, int y, int) { return 1047 + 223 * slope(x, y); });
}

TEST(Heights, OfOneChannelOrGreyStayAsTheyAreWithoutANote) {
    for (const int bits : {8, 16, 32})
        for (const int channels : {1, 2, 3, 4}) {
            const Heights found = heights_in(picture(
                channels, bits, [&](int x, int y, int c) { return c % 2 && c == channels - 1 ? 1 : slope(x, y); }));
            EXPECT_EQ(found.image.values, slopes().values) << channels << " channels";
            EXPECT_EQ(found.image.bits, bits);
            EXPECT_EQ(found.channel, 0);
            EXPECT_TRUE(found.notes.empty() && found.voids.empty());
        }
}

TEST(Heights, AreInGreyAndNotInAnAlphaThatVaries) {
    for (const int channels : {2, 4}) {
        const Heights found = heights_in(picture(
            channels, 16, [&](int x, int y, int c) { return c == channels - 1 ? other_slope(x, y) : slope(x, y); }));
        EXPECT_EQ(found.image.values, slopes().values);
        ASSERT_EQ(found.notes.size(), 1u);
        EXPECT_TRUE(contains(found.notes[0], "alpha, is not read")) << found.notes[0];
    }
}

TEST(Heights, AreInTheLastChannelBesideOneColourOrColoursOrNormals) {
    const auto beside = [](const std::function<float(int, int, int)>& color) {
        return picture(4, 16, [&](int x, int y, int c) { return c == 3 ? slope(x, y) : color(x, y, c); });
    };
    const Heights white = heights_in(beside([](int, int, int) { return 1.0f; }));
    EXPECT_EQ(white.channel, 3);
    EXPECT_EQ(white.image.values, slopes().values);
    EXPECT_EQ(white.notes.size(), 1u);
    const Heights colors = heights_in(beside([](int x, int y, int c) { return c == 0 ? other_slope(x, y) : 0.0f; }));
    EXPECT_EQ(colors.image.values, slopes().values);
    EXPECT_TRUE(contains(colors.notes.at(0), "show colours")) << colors.notes.at(0);
    EXPECT_TRUE(colors.normals.values.empty());
    const Heights normals = heights_in(beside([](int, int, int c) { return c == 2 ? 1.0f : 0.5f; }));
    EXPECT_EQ(normals.image.values, slopes().values);
    EXPECT_EQ(normals.normals.channels, 3);
    // A light grey has unit length as a vector, and is still grey.
    const Heights light = heights_in(
        picture(4, 8, [](int x, int y, int c) { return c == 3 ? slope(x, y) : 0.7f + 0.17f * other_slope(x, y); }));
    EXPECT_EQ(light.channel, 0);
}

TEST(Heights, AreNotInColours) {
    const Image colors = picture(3, 8, [](int x, int y, int c) { return c == 0 ? slope(x, y) : 0.0f; });
    EXPECT_EQ(
        message_of([&] { heights_in(colors); }),
        "shows colours or normals: a height map is grey, or the fourth channel of a picture. `relief map heights` "
        "makes heights of a picture");
}

TEST(Heights, NanAndInfinityAreFilledFromTheHeightsAround) {
    for (const float hole : {NAN, INFINITY, -INFINITY}) {
        Image map = slopes(32);
        for (int y = 9; y < 13; ++y)
            for (int x = 9; x < 13; ++x) *map.pixel(x, y) = hole;
        const Heights found = heights_in(map);
        EXPECT_EQ(found.not_finite, 16u);
        ASSERT_EQ(found.notes.size(), 1u);
        EXPECT_TRUE(contains(found.notes[0], "16 texels hold NaN or infinity")) << found.notes[0];
        for (int y = 0; y < map_side; ++y)
            for (int x = 0; x < map_side; ++x) {
                const float height = *found.image.pixel(x, y);
                if (std::isfinite(*map.pixel(x, y)))
                    EXPECT_EQ(height, *map.pixel(x, y));
                else  // a mean of heights at most 4 texels away
                    EXPECT_NEAR(height, slope(x, y), 4.0f / (map_side - 1));
            }
    }
    EXPECT_TRUE(
        contains(message_of([] { heights_in(picture(1, 32, [](int, int, int) { return NAN; })); }), "no height"));
}

TEST(Heights, MetresAreScaledFromTheirOwnLeastToTheirGreatest) {
    const Heights found = heights_in(mountains());
    for (size_t i = 0; i < found.image.values.size(); ++i) EXPECT_NEAR(found.image.values[i], slopes().values[i], 1e-6);
    EXPECT_EQ(found.low, 1047);
    EXPECT_EQ(found.high, 1270);
    EXPECT_EQ(found.notes, std::vector<std::string>{"heights from 1047 to 1270 are scaled to 0 to 1"});
    const Heights around_0 = heights_in(picture(1, 32, [](int x, int y, int) { return slope(x, y) - 0.5f; }));
    EXPECT_EQ(around_0.low, -0.5);
    EXPECT_EQ(around_0.high, 0.5);
    const Heights flat = heights_in(picture(1, 32, [](int, int, int) { return 300.0f; }));
    EXPECT_EQ(flat.image.values, std::vector<float>(map_side * map_side, 0.0f));
}

TEST(Heights, AMarkOfMissingDataIsNamedWithItsCountAndFilled) {
    for (const float mark : {-9999.0f, -32768.0f, -3.4e38f, -std::numeric_limits<float>::max(), 32768.0f, 1e20f,
                             65504.0f, 0.0f, -777.0f}) {
        Image map = mountains();
        for (int y = 5; y < 8; ++y) *map.pixel(7, y) = mark;
        const Heights found = heights_in(map);
        ASSERT_EQ(found.notes.size(), 2u) << mark;
        EXPECT_TRUE(found.notes[0].starts_with("3 texels hold ")) << found.notes[0];
        EXPECT_TRUE(contains(found.notes[0], "far from all others (1047 to 1270): voids")) << found.notes[0];
        EXPECT_EQ(found.low, 1047) << mark;
        EXPECT_EQ(found.high, 1270) << mark;
        for (int y = 5; y < 8; ++y) EXPECT_NEAR(*found.image.pixel(7, y), slope(7, y), 0.1) << mark;
        EXPECT_EQ(std::count(found.voids.begin(), found.voids.end(), 1), 3);
    }
    Image both = mountains();
    both.values[3] = -9999, both.values[99] = -32768, both.values[100] = NAN;
    EXPECT_EQ(heights_in(both).notes.size(), 4u) << "each mark has its note";
}

TEST(Heights, AValueThatIsNotFarFromTheOthersIsNoVoid) {
    Image sea = picture(1, 32, [](int x, int y, int) { return -11000 + 19000 * slope(x, y); });
    sea.values[5] = -9999;  // a depth like others
    EXPECT_TRUE(heights_in(sea).voids.empty());
    // A wall whose joints are at exactly 0 and whose bricks are nearly level.
    for (const int bits : {8, 16, 32}) {
        const Image wall =
            picture(1, bits, [](int x, int y, int) { return x % 8 == 0 ? 0 : 0.95f + 0.05f * slope(x, y); });
        const Heights found = heights_in(wall);
        EXPECT_EQ(found.image.values, wall.values);
        EXPECT_TRUE(found.voids.empty());
    }
    EXPECT_TRUE(heights_in(picture(1, 32, [](int x, int, int) { return x % 2 ? 5.0f : 0.0f; })).voids.empty())
        << "two values are far from each other";
}

TEST(Heights, In16BitsOnly32768IsSurelyAVoid) {
    const auto with = [](int code) {
        Image map = picture(1, 16, [](int x, int y, int) { return std::round(1047 + 223 * slope(x, y)) / 65535; });
        map.values[50] = float(code) / 65535;
        return heights_in(map);
    };
    const Heights wrapped = with(32768);
    ASSERT_EQ(wrapped.notes.size(), 1u);
    EXPECT_TRUE(wrapped.notes[0].starts_with("1 texel holds 32768, far from all others (1047 to 1270): voids"))
        << wrapped.notes[0];
    EXPECT_NEAR(wrapped.image.values[50] * 65535, 1047 + 223 * slope(50 % map_side, 0), 25);
    for (const int code : {0, 65535}) {
        const Heights named = with(code);
        ASSERT_EQ(named.notes.size(), 1u);
        EXPECT_TRUE(contains(named.notes[0], "if it marks voids")) << named.notes[0];
        EXPECT_EQ(named.image.values[50], float(code) / 65535);
    }
}

}  // namespace
}  // namespace relief
