// Mip chains preserve the mean, and average colour as light.
#include "framework/core/image/mips.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
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

TEST(Mips, HalveAndRoundDownToOneTexel) {
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

TEST(Mips, WeightTexelsPartiallyAtOddSizes) {
    Image row(5, 1, 1);
    row.values = {1, 2, 3, 4, 5};
    // Two texels cover two and a half each: (1 + 2 + 3 / 2) / 2.5 and (3 / 2 + 4 + 5) / 2.5.
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

TEST(Mips, AverageColourInLinearLight) {
    // Half black and half white is half the light: srgb_from_linear(0.5) = 0.73536, which is 188 in 8 bits, not 128.
    Image image(2, 1, 3, 8);
    std::fill(image.values.begin() + 3, image.values.end(), 1.0f);
    const Image light = mip_chain(image, ColorSpace::srgb).back(), number = mip_chain(image, ColorSpace::linear).back();
    for (const float value : light.values) EXPECT_EQ(value, 188 / 255.0f);
    for (const float value : number.values) EXPECT_EQ(value, 0.5f);
    image.bits = 32;
    EXPECT_FLOAT_EQ(mip_chain(image, ColorSpace::srgb).back().values[0], 0.735356983f);
}

TEST(Mips, AreNotRoundedBetweenLevels) {
    // Sierpinski's triangle in the darkest grey: 27 of 64 texels are 1, so the mean is 0.42, which rounds to 0. If each
    // level were rounded, 3/4 would become 1 every time.
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

Image stored(const std::vector<glm::dvec3>& normals, int width) {
    Image image(width, int(normals.size()) / width, 3);
    for (size_t i = 0; i < normals.size(); ++i)
        for (int c = 0; c < 3; ++c) image.values[i * 3 + size_t(c)] = float(0.5 * normals[i][c] + 0.5);
    return image;
}

TEST(NormalMips, KeepEqualNormalsAtFullLength) {
    const glm::dvec3 tilted = glm::normalize(glm::dvec3(0.3, -0.4, 0.8));
    const auto chain =
        normal_mip_chain(stored(std::vector<glm::dvec3>(35, 0.9 * tilted), 7));  // not unit, as in 8 bits
    ASSERT_EQ(chain.size(), 3u);
    for (const Image& level : chain) {
        EXPECT_EQ(level.channels, 4);
        for (size_t i = 0; i < level.pixel_count(); ++i) {
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(level.values[i * 4 + size_t(c)], 0.5 * tilted[c] + 0.5, 1e-6);
            EXPECT_NEAR(level.values[i * 4 + 3], 1, 1e-6);
            EXPECT_LE(level.values[i * 4 + 3], 1);
        }
    }
}

TEST(NormalMips, AreUnitAndStoreTheLengthOfTheMean) {
    // Two normals at 60 degrees to each other: the length of their mean is cos(30 degrees).
    const double s = std::sin(M_PI / 6), c = std::cos(M_PI / 6);
    const auto chain = normal_mip_chain(stored({{s, 0, c}, {-s, 0, c}}, 2));
    EXPECT_NEAR(chain[1].values[0], 0.5, 1e-6);
    EXPECT_NEAR(chain[1].values[2], 1, 1e-6);
    EXPECT_NEAR(chain[1].values[3], c, 1e-6);
}

TEST(NormalMips, OfCancellingNormalsPointUpWithLengthZero) {
    const auto chain = normal_mip_chain(stored({{1, 0, 0}, {-1, 0, 0}}, 2));
    EXPECT_EQ(chain[1].values, (std::vector<float>{0.5f, 0.5f, 1, 0}));
    const auto broken = normal_mip_chain(stored({{NAN, 0, 0}, {0, 0, 1}}, 2));
    EXPECT_EQ(broken[1].values, (std::vector<float>{0.5f, 0.5f, 1, 1})) << "what is not a number points up";
}

TEST(NormalMips, HaveTheAnalyticMeanLengthForRandomSlopes) {
    // Slopes are N(0, s²) in both directions. |mean n| is the mean of n.z = 1 / sqrt(1 + r²), where r² / s² is
    // exponentially distributed with mean 2.
    const double s = 0.3;
    std::mt19937 random(31);
    std::normal_distribution<> slope(0, s);
    std::vector<glm::dvec3> normals(256 * 256);
    for (glm::dvec3& n : normals) n = glm::normalize(glm::dvec3(-slope(random), -slope(random), 1));
    double integral = 0;
    const int steps = 20000;
    for (int i = 0; i < steps; ++i) {
        const double r2 = -2 * s * s * std::log((i + 0.5) / steps);
        integral += 1 / std::sqrt(1 + r2) / steps;
    }
    // The standard deviation of n.z is 0.07, over 65,536 texels.
    EXPECT_NEAR(normal_mip_chain(stored(normals, 256)).back().values[3], integral, 0.07 / 256 * 4);
}

TEST(Toksvig, FactorIsOneForEqualNormalsAndFallsWithShininess) {
    EXPECT_EQ(toksvig_factor(1, 512), 1);
    EXPECT_EQ(toksvig_factor(0, 512), 0);
    EXPECT_DOUBLE_EQ(toksvig_factor(0.5, 1), 0.5);
    EXPECT_NEAR(toksvig_factor(126.0 / 127, 512), 0.2, 0.003) << "one step of 8 signed bits";
}

TEST(Gloss, FallsWhereANormalDiffersFromItsNeighboursAlsoAcrossTheBorder) {
    Image normals(6, 5, 3);
    for (size_t i = 2; i < normals.values.size(); i += 3) normals.values[i] = 1;
    float* const corner = normals.pixel(0, 0);
    corner[0] = 1, corner[2] = 0;
    const Image gloss = gloss_of(normals, 64);
    const double length = std::hypot(1, 8) / 9;  // of one normal along x and eight along z
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 6; ++x) {
            const bool is_near = (x <= 1 || x == 5) && (y <= 1 || y == 4);
            EXPECT_NEAR(*gloss.pixel(x, y), is_near ? length / (length + 64 * (1 - length)) : 1, 1e-6)
                << x << ", " << y;
        }
}

}  // namespace
}  // namespace relief
