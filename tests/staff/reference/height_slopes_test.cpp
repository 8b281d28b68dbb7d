// Normals from heights: the fast implementation against the definition, and the definition against plane waves of known
// slope.
#include "framework/staff/reference/height_slopes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "framework/core/base/error.h"
#include "framework/core/image/color.h"
#include "framework/staff/reference/degrees.h"

namespace relief {

static void PrintTo(SlopeFilter filter, std::ostream* stream) {
    *stream << std::map<SlopeFilter, const char*>{{SlopeFilter::forward, "forward"},
                                                  {SlopeFilter::central, "central"},
                                                  {SlopeFilter::sobel, "sobel"},
                                                  {SlopeFilter::scharr, "scharr"},
                                                  {SlopeFilter::fourth_order, "fourth order"},
                                                  {SlopeFilter::spline, "spline"}}[filter];
}

namespace {

using F = SlopeFilter;
constexpr F filters[] = {F::forward, F::central, F::sobel, F::scharr, F::fourth_order, F::spline};

template <class Height>
Image heights(int width, int height, Height at) {
    Image image(width, height, 1);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) *image.pixel(x, y) = float(at(x, y));
    return image;
}

Image random_heights(unsigned seed, int width, int height) {
    std::mt19937 random(seed);
    return heights(width, height, [&](int, int) { return std::uniform_real_distribution<>(0, 1)(random); });
}

glm::dvec3 decoded(const Image& normals, int x, int y) {
    const float* const texel = normals.pixel(x, y);
    return {texel[0] * 2.0 - 1, texel[1] * 2.0 - 1, texel[2] * 2.0 - 1};
}

TEST(NormalsFromHeights, MatchTheDefinitionForEverySizeFilterAndBorder) {
    const unsigned seed = 21;
    const int sizes[][2] = {{1, 1}, {1, 7},  {9, 1},  {2, 2},  {3, 5},   {4, 4},
                            {5, 3}, {10, 6}, {11, 2}, {12, 9}, {33, 17}, {40, 4}};
    for (const auto& [width, height] : sizes)
        for (const F filter : filters)
            for (const bool wrap : {true, false}) {
                SCOPED_TRACE(testing::Message() << width << "x" << height << ", " << testing::PrintToString(filter)
                                                << (wrap ? ", wraps" : ", ends") << ", seed " << seed);
                const Image map = random_heights(seed, width, height);
                const NormalOptions options{.texels_u = 3, .texels_v = 0.7, .filter = filter, .wrap = wrap};
                const Image normals = normals_from_heights(map, options);
                double largest = 0;
                for (int y = 0; y < height; ++y)
                    for (int x = 0; x < width; ++x)
                        largest =
                            std::max(largest, glm::length(decoded(normals, x, y) - normal_at(map, x, y, options)));
                // A slope of 3 in single precision, and 0.5 n + 0.5 rounded to 2^-24. Decoding doubles that error.
                ASSERT_LT(largest, 6e-7);
            }
}

TEST(NormalsFromHeights, OfAPlaneAreExactUpToTheBorder) {
    const Image plane = heights(9, 8, [](int x, int y) { return x / 16.0 - y / 32.0; });  // exact in floats
    for (const F filter : filters) {
        const Image normals =
            normals_from_heights(plane, {.texels_u = 8, .texels_v = 16, .filter = filter, .wrap = false});
        for (int y = 0; y < 8; ++y)
            for (int x = 0; x < 9; ++x)
                EXPECT_LT(degrees_between(decoded(normals, x, y), {-0.5, -0.5, 1}), 1e-5)
                    << testing::PrintToString(filter) << " " << x << ", " << y;
    }
}

TEST(NormalsFromHeights, OfAnInfiniteSlopeLieFlatInItsDirection) {
    const Image plane = heights(24, 24, [](int x, int y) { return (3 * x + 4 * y) / 128.0; });
    for (const double texels : {1e3, 1e18, 1e21, 1e30})
        for (const F filter : {F::central, F::sobel, F::spline}) {
            const Image normals =
                normals_from_heights(plane, {.texels_u = texels, .texels_v = texels, .filter = filter, .wrap = false});
            // Rows run down and v runs up: the normal is (-3, 4) / 5, horizontal. At 1e3 it still rises by 1 / 39.
            EXPECT_NEAR(decoded(normals, 12, 12).x, -0.6, 1e-3) << texels;
            EXPECT_NEAR(decoded(normals, 12, 12).y, 0.8, 1e-3) << texels;
            EXPECT_EQ(normals.bits, 8);
        }
}

TEST(NormalsFromHeights, AtTheBorderWrapOrUseSecondOrderOneSidedDifferences) {
    const Image row = heights(4, 1, [](int x, int) { return x * x; });  // 0 1 4 9, of slopes 0 2 4 6
    const Image column = heights(1, 4, [](int, int y) { return y * y; });
    const auto expect = [](const Image& map, bool wrap, int x, int y, double du, double dv) {
        EXPECT_LT(degrees_between(decoded(normals_from_heights(map, {.wrap = wrap}), x, y), {-du, -dv, 1}), 1e-5)
            << wrap << ": " << x << ", " << y;
    };
    expect(row, true, 0, 0, (1.0 - 9.0) / 2, 0);
    expect(row, false, 0, 0, 0, 0);
    expect(row, true, 3, 0, (0.0 - 4.0) / 2, 0);
    expect(row, false, 3, 0, 6, 0);
    expect(column, true, 0, 0, 0, (9.0 - 1.0) / 2);
    expect(column, false, 0, 3, 0, -6);
}

TEST(NormalsFromHeights, ShiftWithTheTile) {
    const int width = 37, height = 21;
    const Image map = random_heights(22, width, height);
    const Image shifted =
        heights(width, height, [&](int x, int y) { return *map.pixel((x + 30) % width, (y + 13) % height); });
    for (const F filter : filters) {
        const Image normals = normals_from_heights(map, {.texels_u = 5, .texels_v = 5, .filter = filter}),
                    moved = normals_from_heights(shifted, {.texels_u = 5, .texels_v = 5, .filter = filter});
        double largest = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = 0; c < 3; ++c)
                    largest = std::max<double>(
                        largest,
                        std::abs(moved.pixel(x, y)[c] - normals.pixel((x + 30) % width, (y + 13) % height)[c]));
        // Borders are computed in double precision, and the inside in single precision.
        EXPECT_LT(largest, 3e-7) << testing::PrintToString(filter);
    }
}

TEST(NormalsFromHeights, AreEqualForAnyNumberOfThreadsAndInAReusedImage) {
    const Image map = random_heights(23, 200, 150);
    for (const F filter : filters) {
        const NormalOptions options{.texels_u = 5, .texels_v = 4, .filter = filter, .level_strengths = {0.5, 2}};
        const Image normals = normals_from_heights(map, options);
        Image other(3, 3, 1);
        for (const unsigned threads : {1u, 2u, 5u}) {
            normals_from_heights(map, options, other, threads);
            EXPECT_EQ(other.values, normals.values) << testing::PrintToString(filter) << " " << threads;
        }
    }
}

TEST(NormalsFromHeights, OfALargeMapMatchTheDefinitionInSampledRows) {
    // Large enough for writes that bypass the caches: 1100 x 1000 texels of 12 bytes. With 1101 columns, rows begin at
    // any alignment.
    const Image map = random_heights(24, 1101, 1000);
    const NormalOptions options{.texels_u = 5, .texels_v = 4, .filter = F::sobel};
    const Image normals = normals_from_heights(map, options);
    for (const int y : {0, 1, 499, 998, 999})
        for (int x = 0; x < map.width; ++x)
            ASSERT_LT(glm::length(decoded(normals, x, y) - normal_at(map, x, y, options)), 6e-7) << x << ", " << y;
}

TEST(NormalsFromHeights, StayUnitForAnyHeights) {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    for (const double odd : {nan, inf, -inf, 1e38, -1e38, 1e-40, -0.0})
        for (const F filter : filters) {
            if (filter == F::spline && !std::isfinite(odd)) continue;  // tested below
            Image map = random_heights(25, 24, 6);
            *map.pixel(11, 3) = float(odd);
            const Image normals = normals_from_heights(map, {.texels_u = 1e10, .texels_v = 1, .filter = filter});
            for (int y = 0; y < 6; ++y)
                for (int x = 0; x < 24; ++x)
                    ASSERT_NEAR(glm::length(decoded(normals, x, y)), 1, 1e-6)
                        << odd << " " << testing::PrintToString(filter) << " " << x << ", " << y;
        }
    Image hole = random_heights(26, 24, 6);
    *hole.pixel(11, 3) = std::nanf("");
    const Image spline = normals_from_heights(hole, {.filter = F::spline});
    EXPECT_EQ(decoded(spline, 0, 3).x, 0) << "the whole row knows no slope";
    EXPECT_EQ(decoded(spline, 11, 0).y, 0) << "and the whole column";
    for (size_t i = 0; i < spline.values.size(); ++i) ASSERT_TRUE(std::isfinite(spline.values[i]));
}

TEST(NormalsFromHeights, RefuseImagesOfSeveralChannels) {
    EXPECT_THROW(normals_from_heights(Image(4, 4, 3), {}), Error);
    EXPECT_EQ(normals_from_heights(Image(0, 0, 1), {}).pixel_count(), 0u);
}

/// Mean and largest error in degrees over directions and phases of a plane wave whose steepest slope is 1, and the
/// largest error of the slope's direction.
struct WaveError {
    double mean = 0, largest = 0, direction = 0;
};
WaveError wave_error(F filter, double wavelength) {
    WaveError error;
    const double w = 2 * M_PI / wavelength;
    const int turns = 64, phases = 64;
    for (int i = 0; i < turns; ++i) {
        // A filter along one axis scales cos(w_x) by its gain. The slope of the wave is (gain_x, gain_y) cos(phase).
        const double turn = M_PI / 2 * (i + 0.5) / turns, wx = w * std::cos(turn), wy = w * std::sin(turn);
        const auto gain = [&](double along, double across) {
            switch (filter) {
                case F::central:
                    return std::sin(along);
                case F::sobel:
                    return std::sin(along) * (1 + std::cos(across)) / 2;
                case F::scharr:
                    return std::sin(along) * (10 + 6 * std::cos(across)) / 16;
                case F::fourth_order:
                    return (8 * std::sin(along) - std::sin(2 * along)) / 6;
                default:
                    return 3 * std::sin(along) / (2 + std::cos(along));
            }
        };
        const glm::dvec2 measured = glm::dvec2(gain(wx, wy), gain(wy, wx)) / w, exact = glm::dvec2(wx, wy) / w;
        error.direction = std::max(error.direction, glm::degrees(std::abs(std::atan2(measured.y, measured.x) - turn)));
        for (int j = 0; j < phases; ++j) {
            const double slope = std::cos(2 * M_PI * (j + 0.5) / phases);
            const double one = degrees_between({-slope * measured, 1}, {-slope * exact, 1});
            error.mean += one / (turns * phases), error.largest = std::max(error.largest, one);
        }
    }
    return error;
}

TEST(SlopeFilter, DampsAPlaneWaveByItsGain) {
    // A wave over a tile of 16 x 12 texels, with 3 periods along u and 2 along v. The gains in wave_error belong to the
    // filters.
    const double wx = 2 * M_PI * 3 / 16, wy = 2 * M_PI * 2 / 12;
    const Image wave = heights(16, 12, [&](int x, int y) { return std::sin(wx * x - wy * y); });
    const auto expect = [&](F filter, double u, double v) {
        for (const auto& [x, y] : {std::pair(0, 0), std::pair(5, 7), std::pair(15, 11)}) {
            const double cosine = std::cos(wx * x - wy * y);
            const glm::dvec2 slope = slope_at(wave, x, y, filter, true);
            EXPECT_NEAR(slope.x, u * cosine, 1e-6) << testing::PrintToString(filter);  // the heights are floats
            EXPECT_NEAR(slope.y, v * cosine, 1e-6) << testing::PrintToString(filter);
        }
    };
    const double sx = std::sin(wx), sy = std::sin(wy), cx = std::cos(wx), cy = std::cos(wy);
    expect(F::central, sx, sy);
    expect(F::sobel, sx * (1 + cy) / 2, sy * (1 + cx) / 2);
    expect(F::scharr, sx * (10 + 6 * cy) / 16, sy * (10 + 6 * cx) / 16);
    expect(F::fourth_order, (8 * sx - std::sin(2 * wx)) / 6, (8 * sy - std::sin(2 * wy)) / 6);
    expect(F::spline, 3 * sx / (2 + cx), 3 * sy / (2 + cy));
}

TEST(SlopeFilter, HasTheKnownErrorOnPlaneWaves) {
    struct Row {
        double wavelength;
        F filter;
        double mean, largest;
    };
    // Degrees over all directions and phases, for a steepest slope of 1. Computed by a separate program.
    for (const Row& row :
         {Row{4, F::central, 7.29, 12.5}, Row{4, F::sobel, 10.1, 14.8}, Row{4, F::scharr, 9.30, 12.5},
          Row{4, F::fourth_order, 2.47, 4.67}, Row{4, F::spline, 0.669, 1.32}, Row{8, F::central, 1.83, 3.00},
          Row{8, F::sobel, 2.61, 3.72}, Row{8, F::scharr, 2.39, 3.14}, Row{8, F::fourth_order, 0.181, 0.340},
          Row{8, F::spline, 0.034, 0.065}, Row{16, F::central, 0.457, 0.740}, Row{16, F::sobel, 0.656, 0.923},
          Row{16, F::scharr, 0.599, 0.784}, Row{16, F::fourth_order, 0.0118, 0.0223},
          Row{16, F::spline, 0.0020, 0.0039}, Row{32, F::central, 0.114, 0.184}, Row{32, F::sobel, 0.164, 0.230},
          Row{32, F::scharr, 0.150, 0.196}}) {
        const WaveError error = wave_error(row.filter, row.wavelength);
        // The table has two or three digits, and it samples directions slightly differently: up to 1.1 % at 4 texels.
        EXPECT_NEAR(error.mean, row.mean, 0.012 * row.mean + 0.00005)
            << row.wavelength << testing::PrintToString(row.filter);
        EXPECT_NEAR(error.largest, row.largest, 0.012 * row.largest + 0.00005)
            << row.wavelength << testing::PrintToString(row.filter);
    }
    // The largest error of the slope's direction, which Scharr minimizes.
    EXPECT_NEAR(wave_error(F::central, 8).direction, 1.54, 0.01);
    EXPECT_NEAR(wave_error(F::sobel, 8).direction, 0.754, 0.005);
    EXPECT_NEAR(wave_error(F::scharr, 8).direction, 0.162, 0.002);
    EXPECT_NEAR(wave_error(F::fourth_order, 8).direction, 0.172, 0.002);
    EXPECT_NEAR(wave_error(F::spline, 8).direction, 0.032, 0.001);
}

TEST(SlopeFilter, HasTheKnownErrorOn8And16BitHeights) {
    // Rounding is noise with a standard deviation of 1/sqrt(12) of a step. This is the rms error of the normal of a
    // flat, dithered map, in degrees.
    const auto rms = [](F filter, double amplitude, int steps) {
        std::mt19937 random(27);
        const Image rounded = heights(192, 192, [&](int, int) {
            const double height = std::uniform_real_distribution<>(0.2, 0.8)(random);
            return std::round(height * steps) / steps - height;  // rounding error
        });
        const Image normals =
            normals_from_heights(rounded, {.texels_u = amplitude, .texels_v = amplitude, .filter = filter});
        double sum = 0;
        for (int y = 0; y < 192; ++y)
            for (int x = 0; x < 192; ++x) sum += std::pow(degrees_between(decoded(normals, x, y), {0, 0, 1}), 2);
        return std::sqrt(sum / (192 * 192));
    };
    struct Row {
        F filter;
        double at4, at16;
    };
    for (const Row& row : {Row{F::central, 0.259, 1.04}, Row{F::sobel, 0.159, 0.636}, Row{F::scharr, 0.176, 0.705}}) {
        EXPECT_NEAR(rms(row.filter, 4, 255), row.at4, 0.03 * row.at4) << testing::PrintToString(row.filter);
        EXPECT_NEAR(rms(row.filter, 16, 255), row.at16, 0.03 * row.at16) << testing::PrintToString(row.filter);
        EXPECT_NEAR(rms(row.filter, 16 * 257, 65535), row.at16, 0.03 * row.at16) << "16 bits: 257 times the amplitude";
    }
}

TEST(LevelStrengths, OfOneChangeNothingAndOfZeroRemoveTheFinestDetail) {
    const Image map = random_heights(28, 40, 30);
    EXPECT_EQ(normals_from_heights(map, {.level_strengths = {1, 1, 1}}).values, normals_from_heights(map, {}).values);
    // The cubic B-spline has a zero of fourth order at a wavelength of two texels, so the finest level contains that
    // wave completely.
    const Image finest =
        heights(16, 16, [](int x, int y) { return 0.5 + (((x + y) & 1) ? 0.25 : -0.25) * ((x & 1) ? 1 : 1); });
    const Image flat = normals_from_heights(finest, {.filter = F::forward, .level_strengths = {0}});
    for (size_t i = 0; i < flat.pixel_count(); ++i) ASSERT_NEAR(flat.values[i * 3 + 2], 1, 1e-6);
    const Image doubled = normals_from_heights(finest, {.filter = F::forward, .level_strengths = {2}}),
                twice = normals_from_heights(finest, {.texels_u = 2, .texels_v = 2, .filter = F::forward});
    for (size_t i = 0; i < doubled.values.size(); ++i) ASSERT_NEAR(doubled.values[i], twice.values[i], 1e-6);
}

TEST(LevelStrengths, OfAllLevelsActAsOneStrength) {
    // All levels of the tile are doubled, and only the mean is left. So all slopes are doubled.
    const Image map = random_heights(29, 16, 16);
    const Image all = normals_from_heights(map, {.level_strengths = {2, 2, 2, 2, 2}}),
                twice = normals_from_heights(map, {.texels_u = 2, .texels_v = 2});
    for (size_t i = 0; i < all.values.size(); ++i)
        ASSERT_NEAR(all.values[i], twice.values[i], 0.01) << "what five levels leave is wider than the map";
    const Image odd =
        normals_from_heights(random_heights(30, 3, 1), {.wrap = false, .level_strengths = {3, 2, 1, 0, 9, 9}});
    for (const float value : odd.values) EXPECT_TRUE(std::isfinite(value)) << "more levels than the map has";
}

TEST(HeightsFromColor, KeepGreyValuesAndTakeTheLuminanceOfColours) {
    Image color(2, 1, 4, 8);
    color.values = {0.4f, 0.4f, 0.4f, 0.1f, 1, 0, 0, 1};
    const Image stored = heights_from_color(color, ColorSpace::srgb);
    EXPECT_EQ(stored.channels, 1);
    EXPECT_NEAR(stored.values[0], 0.4, 1e-6) << "grey stays what it is";
    EXPECT_NEAR(stored.values[1], srgb_from_linear(0.2126), 1e-6) << "red";
    EXPECT_NEAR(heights_from_color(color, ColorSpace::linear).values[1], srgb_from_linear(0.2126), 1e-6);
    Image grey(1, 1, 2);
    grey.values = {0.25f, 1};
    EXPECT_NEAR(heights_from_color(grey, ColorSpace::srgb).values[0], 0.25, 1e-6);
}

}  // namespace
}  // namespace relief
