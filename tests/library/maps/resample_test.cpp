// Resampling of maps that tile.
#include "framework/library/maps/resample.h"

#include <cmath>
#include <numbers>

#include "tests/support.h"

namespace relief {
namespace {

Image wave(int width, int height) {
    Image image(width, height, 2);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            image.pixel(x, y)[0] = float(std::cos(2 * std::numbers::pi * (x + 0.5) / width));
            image.pixel(x, y)[1] = float(std::sin(2 * std::numbers::pi * (y + 0.5) / height));
        }
    return image;
}

TEST(Resample, KeepsAMapOfTheTargetSizeUnchanged) {
    const Image image = wave(7, 5);
    EXPECT_EQ(resampled(image, 7, 5).values, image.values);
}

TEST(Resample, KeepsMeanAndPositionOfATileAtLargerAndSmallerSizes) {
    const Image image = wave(48, 40);
    for (const auto& [width, height] : {std::pair(96, 100), std::pair(24, 17), std::pair(33, 57)}) {
        const Image other = resampled(image, width, height), exact = wave(width, height);
        double sum = 0, worst = 0;
        for (size_t i = 0; i < other.values.size(); ++i) {
            sum += double(other.values[i]);
            worst = std::max(worst, std::abs(double(other.values[i]) - double(exact.values[i])));
        }
        EXPECT_NEAR(sum / double(other.values.size()), 0, 1e-3) << width;
        EXPECT_LT(worst, 0.03) << width << " x " << height << ": a map that is moved by half a texel is off by 0.06";
    }
}

TEST(Resample, WorksToAndFromASingleTexel) {
    EXPECT_NEAR(double(resampled(wave(64, 64), 1, 1).values[0]), 0, 0.05);
    Image one(1, 1, 1);
    one.values = {0.25f};
    for (const float value : resampled(one, 4, 3).values) EXPECT_FLOAT_EQ(value, 0.25f);
}

}  // namespace
}  // namespace relief
