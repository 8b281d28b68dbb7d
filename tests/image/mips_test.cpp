// Mip chains keep the mean, of light where the image is colour.
#include "framework/image/mips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace relief {
namespace {

Image noise(int width, int height, int channels, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> value(0, 1);
    Image image(width, height, channels);
    for (float& v : image.values) v = value(random);
    return image;
}

double mean(const Image& image, int channel) {
    double sum = 0;
    for (size_t i = 0; i < image.pixel_count(); ++i) sum += image.values[i * image.channels + channel];
    return sum / double(image.pixel_count());
}

TEST(Mips, HalveRoundedDownUntilOneTexel) {
    const std::vector<Image> chain = mip_chain(Image(12, 5, 2, 8), ColorSpace::linear);
    const int sizes[][2] = {{12, 5}, {6, 2}, {3, 1}, {1, 1}};
    ASSERT_EQ(chain.size(), std::size(sizes));
    for (size_t i = 0; i < chain.size(); ++i) {
        EXPECT_EQ(chain[i].width, sizes[i][0]) << "level " << i;
        EXPECT_EQ(chain[i].height, sizes[i][1]) << "level " << i;
        EXPECT_EQ(chain[i].channels, 2);
        EXPECT_EQ(chain[i].bits, 8);
    }
    EXPECT_EQ(mip_chain(Image(1, 1, 1), ColorSpace::srgb).size(), 1u);
}

TEST(Mips, KeepTheMeanOfEveryChannelAtEverySize) {
    const unsigned seed = 7;
    for (const auto& [width, height] : {std::pair(16, 16), {64, 2}, {5, 3}, {7, 1}, {1, 9}, {3, 3}, {31, 17}, {2, 1}}) {
        const Image image = noise(width, height, 3, seed);
        const std::vector<Image> chain = mip_chain(image, ColorSpace::linear);
        for (const Image& level : chain)
            for (int c = 0; c < 3; ++c)
                // Each level rounds each texel to a float.
                EXPECT_NEAR(mean(level, c), mean(image, c), 3e-7)
                    << width << "x" << height << ", level of " << level.width << "x" << level.height << ", seed "
                    << seed;
        EXPECT_EQ(chain.back().pixel_count(), 1u);
    }
}

TEST(Mips, AnOddSideIsCoveredInParts) {
    Image row(5, 1, 1);
    row.values = {1, 2, 3, 4, 5};
    // Two texels of two and a half each: (1 + 2 + 3 / 2) / 2.5 and (3 / 2 + 4 + 5) / 2.5.
    const Image half = mip_chain(row, ColorSpace::linear)[1];
    ASSERT_EQ(half.values.size(), 2u);
    EXPECT_FLOAT_EQ(half.values[0], 1.8f);
    EXPECT_FLOAT_EQ(half.values[1], 4.2f);
}

TEST(Mips, LevelZeroIsTheImageItself) {
    Image image(3, 2, 4, 8);
    for (size_t i = 0; i < image.values.size(); ++i) image.values[i] = float(i * 10) / 255;
    EXPECT_EQ(mip_chain(image, ColorSpace::srgb).front().values, image.values);
    EXPECT_EQ(mip_chain(image, ColorSpace::linear).front().values, image.values);
}

TEST(Mips, AverageColourAsLight) {
    // Half black, half white is half the light: srgb_from_linear(0.5) = 0.73536, in 8 bits 188, not 128.
    Image image(2, 1, 3, 8);
    std::fill(image.values.begin() + 3, image.values.end(), 1.0f);
    const Image light = mip_chain(image, ColorSpace::srgb).back(), number = mip_chain(image, ColorSpace::linear).back();
    for (const float value : light.values) EXPECT_EQ(value, 188 / 255.0f);
    for (const float value : number.values) EXPECT_EQ(value, 0.5f);
    image.bits = 32;
    EXPECT_FLOAT_EQ(mip_chain(image, ColorSpace::srgb).back().values[0], 0.735356983f);
}

TEST(Mips, AreNotRoundedFromLevelToLevel) {
    // Sierpinski's triangle in the darkest grey: 27 of 64 texels are 1, a mean of 0.42, so 0. Rounding on
    // each level would make 3/4 of it 1 again and again.
    Image image(8, 8, 1, 8);
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) *image.pixel(x, y) = (x & y) == 0 ? 1 / 255.0f : 0.0f;
    EXPECT_EQ(mip_chain(image, ColorSpace::srgb).back().values[0], 0.0f);
}

TEST(Mips, AlphaIsNeverSrgb) {
    for (const int channels : {2, 4}) {
        Image image(2, 1, channels, 8);
        std::fill(image.values.begin() + channels, image.values.end(), 1.0f);
        const Image last = mip_chain(image, ColorSpace::srgb).back();
        EXPECT_EQ(last.values.front(), 188 / 255.0f) << channels << " channels";
        EXPECT_EQ(last.values.back(), 0.5f) << channels << " channels";
    }
}

}  // namespace
}  // namespace relief
