// Paint on heights: where it lies, what smoothing does, and limits.
#include "framework/library/kit/paint_layer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace relief {
namespace {

Image flat(int side, float height) {
    Image image(side, side, 1);
    std::fill(image.values.begin(), image.values.end(), height);
    return image;
}

TEST(PaintLayer, WithoutPaintHeightsStayAsTheyAre) {
    Image heights = flat(32, 0.5f);
    heights.values[7] = 1.25f;  // above what paint would allow
    EXPECT_EQ(PaintLayer().on(heights).values, heights.values);
}

TEST(PaintLayer, ADabRaisesADiscByItsStrengthInTheMiddle) {
    PaintLayer layer;
    const Image before = flat(256, 0.4f);
    layer.add({.kind = Dab::raise, .place = {0.25, 0.75}, .radius = 0.125, .strength = 0.2}, before, true);
    const Image after = layer.on(before);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            // v grows upwards, so the middle is in the upper left quarter: 64, 64.
            const double distance = std::hypot(x + 0.5 - 64, y + 0.5 - 64) / 32;
            const double wanted = distance < 1 ? 0.2 * std::pow(1 - distance * distance, 2) : 0;
            ASSERT_NEAR(*after.pixel(x, y) - 0.4, wanted, 1e-6) << x << " " << y;
        }
    layer.add({.kind = Dab::lower, .place = {0.25, 0.75}, .radius = 0.125, .strength = 0.2}, after, true);
    for (const float height : layer.on(before).values) ASSERT_NEAR(height, 0.4f, 1e-6);
}

TEST(PaintLayer, ABrushGoesOnAtTheOtherSideOnlyWhereTheMapWraps) {
    for (const bool wraps : {true, false}) {
        PaintLayer layer;
        const Image before = flat(256, 0.5f);
        layer.add({.place = {0, 0.5}, .radius = 0.1, .strength = 0.3}, before, wraps);
        const Image after = layer.on(before);
        EXPECT_GT(*after.pixel(0, 128), 0.79f);
        EXPECT_EQ(*after.pixel(255, 128) > 0.79f, wraps);
    }
}

TEST(PaintLayer, PaintEndsAtTheLimitsAndComesOffAtOnce) {
    PaintLayer layer;
    const Image before = flat(256, 0.9f);
    const Dab up{.kind = Dab::raise, .place = {0.5, 0.5}, .radius = 0.2, .strength = 0.3};
    for (int i = 0; i < 5; ++i) layer.add(up, layer.on(before), true);
    EXPECT_FLOAT_EQ(*layer.on(before).pixel(128, 128), 1);
    Dab down = up;
    down.kind = Dab::lower;
    layer.add(down, layer.on(before), true);
    EXPECT_NEAR(*layer.on(before).pixel(128, 128), 0.7f, 1e-3);
}

TEST(PaintLayer, SmoothingKeepsPlanesAndLowersPeaks) {
    PaintLayer layer;
    Image plane(256, 256, 1);
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) *plane.pixel(x, y) = 0.1f + 0.003f * float(x);
    const Dab smooth{.kind = Dab::smooth, .place = {0.5, 0.5}, .radius = 0.2, .strength = 1};
    layer.add(smooth, plane, true);
    for (const float change : layer.values().values) EXPECT_NEAR(change, 0, 1e-6);
    *plane.pixel(128, 128) += 0.2f;
    layer.add(smooth, plane, true);
    EXPECT_LT(*layer.on(plane).pixel(128, 128), *plane.pixel(128, 128) - 0.15f);
    EXPECT_GT(*layer.on(plane).pixel(130, 128), *plane.pixel(130, 128) + 0.005f);
}

TEST(PaintLayer, LiesAtTheSamePlaceOnMapsOfAnySize) {
    PaintLayer layer;
    layer.add({.place = {0.75, 0.25}, .radius = 0.2, .strength = 0.4}, flat(32, 0.5f), true);
    for (const int side : {32, 64, 256}) {
        const Image painted = layer.on(flat(side, 0.5f));
        EXPECT_GT(*painted.pixel(side * 3 / 4, side * 3 / 4), 0.85f) << side;
        EXPECT_EQ(*painted.pixel(side / 4, side / 4), 0.5f) << side;
    }
}

TEST(PaintLayer, TakesItsPaintBack) {
    PaintLayer layer;
    const Image before = layer.values();
    const int version = layer.version();
    layer.add({.place = {0.5, 0.5}}, flat(256, 0.5f), true);
    EXPECT_FALSE(layer.is_empty());
    layer.set(before);
    EXPECT_TRUE(layer.is_empty());
    EXPECT_GT(layer.version(), version + 1);
}

}  // namespace
}  // namespace relief
