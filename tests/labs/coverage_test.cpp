// Coverage of masks at their mip levels.
#include "labs/08_obj_materials/coverage.h"

#include <gtest/gtest.h>

#include "framework/core/image/mips.h"

namespace relief {
namespace {

/// Returns a mask of discs in a repeating pattern that is not a power of two.
Image discs(int side) {
    Image mask(side, side, 1, 8);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double u = 7.0 * x / side, v = 7.0 * y / side;
            const double du = u - std::floor(u) - 0.5, dv = v - std::floor(v) - 0.5;
            *mask.pixel(x, y) = du * du + dv * dv < 0.06 ? 1.0f : 0.0f;
        }
    return mask;
}

/// Returns the share above 1/2 at 256 x 256 places of the repeating, bilinear map.
double share_above_half(const Image& level, float scale) {
    int count = 0;
    for (int j = 0; j < 256; ++j)
        for (int i = 0; i < 256; ++i) {
            const float x = (float(i) + 0.5f) / 256 * float(level.width) - 0.5f + float(level.width),
                        y = (float(j) + 0.5f) / 256 * float(level.height) - 0.5f + float(level.height);
            const auto texel = [&](int column, int row) {
                return *level.pixel(column % level.width, row % level.height);
            };
            const int left = int(x), top = int(y);
            const float a = x - float(left), b = y - float(top);
            const float upper = texel(left, top) * (1 - a) + texel(left + 1, top) * a,
                        lower = texel(left, top + 1) * (1 - a) + texel(left + 1, top + 1) * a;
            count += scale * (upper * (1 - b) + lower * b) > 0.5f;
        }
    return count / 65536.0;
}

TEST(CoverageScales, KeepTheShareAboveOneHalfAtEachLevel) {
    const std::vector<Image> levels = mip_chain(discs(256), ColorSpace::linear);
    const std::vector<float> scales = coverage_scales(levels);
    ASSERT_EQ(scales.size(), levels.size());
    EXPECT_EQ(scales[0], 1);
    const double share = share_above_half(levels[0], 1);
    EXPECT_NEAR(share, 0.06 * 3.14159265, 0.005) << "discs of this area";
    // Coarser levels than 8 x 8 have less than a texel per disc and are nearly even.
    for (size_t i = 1; levels[i].width >= 8; ++i) {
        // Two sets of places differ by the places at the rims: less than a hundredth.
        EXPECT_NEAR(share_above_half(levels[i], scales[i]), share, 0.01) << "level " << i;
    }
    EXPECT_LT(share_above_half(levels[4], 1), 0.8 * share) << "without factors the mask thins out";
}

}  // namespace
}  // namespace relief
