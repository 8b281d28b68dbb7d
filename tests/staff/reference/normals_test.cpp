// Normals of height maps with known slopes.
#include "framework/staff/reference/normals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace relief {
namespace {

template <class Height>
Image height_image(int width, int height, Height at) {
    Image image(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) *image.pixel(x, y) = float(at(x, y));
    return image;
}

/// Expects that texel (x, y) is the normal of a surface with these slopes along u and v. The default tolerance of 1e-7
/// is one rounding to float.
void expect_slopes(const Image& normals, int x, int y, double du, double dv, double tolerance = 1e-7) {
    const double length = std::sqrt(du * du + dv * dv + 1), normal[] = {-du / length, -dv / length, 1 / length};
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(normals.pixel(x, y)[c], 0.5 + 0.5 * normal[c], tolerance)
            << "channel " << c << " of texel " << x << ", " << y << " with slopes " << du << ", " << dv;
}

const NormalOptions both_filters[] = {{.filter = SlopeFilter::central}, {.filter = SlopeFilter::sobel}};

TEST(Normals, OfAFlatMapPointStraightUp) {
    for (const NormalOptions& options : both_filters) {
        const Image normals = normals_from_heights(height_image(3, 2, [](int, int) { return 0.7; }), options);
        EXPECT_EQ(normals.channels, 3);
        EXPECT_EQ(normals.bits, 8);
        for (size_t i = 0; i < normals.pixel_count(); ++i) {
            EXPECT_EQ(normals.values[i * 3], 0.5f);
            EXPECT_EQ(normals.values[i * 3 + 1], 0.5f);
            EXPECT_EQ(normals.values[i * 3 + 2], 1.0f);
        }
    }
    EXPECT_EQ(normals_from_heights(Image(1, 1, 1), {}).values, (std::vector<float>{0.5f, 0.5f, 1.0f}));
}

TEST(Normals, OfASlopeOfOneLean45DegreesAgainstIt) {
    const float against = float(0.5 - 0.5 / std::numbers::sqrt2), up = float(0.5 + 0.5 / std::numbers::sqrt2);
    for (const NormalOptions& options : both_filters) {
        const Image along_u = normals_from_heights(height_image(5, 5, [](int x, int) { return x; }), options);
        EXPECT_FLOAT_EQ(along_u.pixel(2, 2)[0], against) << "heights rise to the right: red to the left";
        EXPECT_FLOAT_EQ(along_u.pixel(2, 2)[1], 0.5f);
        EXPECT_FLOAT_EQ(along_u.pixel(2, 2)[2], up);
        const Image along_v = normals_from_heights(height_image(5, 5, [](int, int y) { return -y; }), options);
        EXPECT_FLOAT_EQ(along_v.pixel(2, 2)[0], 0.5f);
        EXPECT_FLOAT_EQ(along_v.pixel(2, 2)[1], against) << "heights rise upwards, to row 0: green down";
        EXPECT_FLOAT_EQ(along_v.pixel(2, 2)[2], up);
    }
}

TEST(Normals, OfAPlaneAreExactWithBothFiltersAndAnyTexelShape) {
    const unsigned seed = 3;
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> slope(-0.1, 0.1), worth(0.5, 40);
    for (int i = 0; i < 100; ++i) {
        const double a = slope(random), b = slope(random);
        const Image plane = height_image(4, 4, [&](int x, int y) { return a * x - b * y; });
        for (NormalOptions options : both_filters) {
            options.texels_u = worth(random), options.texels_v = worth(random);
            // The heights are floats: 3e-8 each, times 40.
            expect_slopes(normals_from_heights(plane, options), 1, 2, a * options.texels_u, b * options.texels_v, 2e-6);
        }
        ASSERT_FALSE(testing::Test::HasFailure()) << "seed " << seed;
    }
}

TEST(Normals, OfAnInfiniteSlopeLieFlatInItsDirection) {
    Image plane(24, 24, 1);
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) *plane.pixel(x, y) = float(3 * x + 4 * y) / 128;
    for (const double texels : {1e3, 1e18, 1e21, 1e30})
        for (const SlopeFilter filter : {SlopeFilter::central, SlopeFilter::sobel, SlopeFilter::spline}) {
            const Image normals =
                normals_from_heights(plane, {.texels_u = texels, .texels_v = texels, .filter = filter, .wrap = false});
            const float* const texel = normals.pixel(12, 12);
            // Rows run down and v runs up: the normal is (-3, 4) / 5, horizontal. At 1e3 it still rises by 1 / 39.
            EXPECT_NEAR(2 * texel[0] - 1, -0.6, 1e-3) << texels;
            EXPECT_NEAR(2 * texel[1] - 1, 0.8, 1e-3) << texels;
        }
}

TEST(Normals, AtTheBorderWrapOrUseSecondOrderOneSidedDifferences) {
    const Image row = height_image(4, 1, [](int x, int) { return x * x; });  // 0 1 4 9, of slopes 0 2 4 6
    const Image tile = normals_from_heights(row, {.wrap = true}), cut = normals_from_heights(row, {.wrap = false});
    expect_slopes(tile, 0, 0, (1.0 - 9.0) / 2, 0);
    expect_slopes(cut, 0, 0, 0, 0);
    expect_slopes(tile, 3, 0, (0.0 - 4.0) / 2, 0);
    expect_slopes(cut, 3, 0, 6, 0);
    const Image column = height_image(1, 4, [](int, int y) { return y * y; });
    expect_slopes(normals_from_heights(column, {.wrap = true}), 0, 0, 0, (9.0 - 1.0) / 2);
    expect_slopes(normals_from_heights(column, {.wrap = false}), 0, 3, 0, -6);
}

TEST(Normals, SobelWeightsTheRowsOneTwoOne) {
    Image spike(5, 5, 1);
    *spike.pixel(2, 2) = 1;
    const Image central = normals_from_heights(spike, {}),
                sobel = normals_from_heights(spike, {.filter = SlopeFilter::sobel});
    expect_slopes(central, 1, 2, 0.5, 0);
    expect_slopes(central, 1, 1, 0, 0);
    expect_slopes(sobel, 1, 2, 0.25, 0);
    expect_slopes(sobel, 1, 1, 0.125, -0.125);
}

TEST(Normals, ConvergeInSecondOrder) {
    // On a sine tile with a known slope, half the texel size gives a quarter of the error.
    const auto largest_error = [](int size) {
        const double turn = 2 * std::numbers::pi / size;
        const Image wave = height_image(size, 1, [&](int x, int) { return std::sin(turn * x); });
        const Image normals = normals_from_heights(wave, {.texels_u = 1 / turn});
        double largest = 0;
        for (int x = 0; x < size; ++x) {
            const double slope = std::cos(turn * x), exact = 0.5 - 0.5 * slope / std::sqrt(slope * slope + 1);
            largest = std::max(largest, std::abs(normals.pixel(x, 0)[0] - exact));
        }
        return largest;
    };
    EXPECT_NEAR(largest_error(32) / largest_error(64), 4, 0.05);
}

}  // namespace
}  // namespace relief
