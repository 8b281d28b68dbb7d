// RGTC: the decoder against values computed by hand from the specification, and the encoders against each other.
#include "framework/staff/reference/rgtc.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "framework/core/base/error.h"

namespace relief {
namespace {

constexpr auto unorm = RgtcKind::unorm, snorm = RgtcKind::snorm;
constexpr RgtcKind kinds[] = {unorm, snorm};

using Values = std::array<double, 16>;

double steps(RgtcKind kind) { return kind == unorm ? 255 : 127; }
double squared(RgtcBlock (*encode)(const Values&, RgtcKind), const Values& values, RgtcKind kind) {
    return rgtc_squared_error(encode(values, kind), values, kind);
}

/// Returns 16 values from `low` to `high`, in 8-bit steps of the format.
Values random_values(std::mt19937& random, RgtcKind kind, double low, double high) {
    std::uniform_real_distribution<> value(low / steps(kind), high / steps(kind));
    Values values;
    for (double& v : values) v = value(random);
    return values;
}

/// Returns a few blocks of each kind: narrow, wide, with values at the limits of the format.
std::vector<Values> blocks_of(RgtcKind kind) {
    std::mt19937 random(3);
    const double low = kind == unorm ? 0 : -127, high = kind == unorm ? 255 : 127;
    std::vector<Values> blocks;
    for (int i = 0; i < 3; ++i) {
        blocks.push_back(random_values(random, kind, 30, 36));
        blocks.push_back(random_values(random, kind, 10, 60));
        blocks.push_back(random_values(random, kind, low, high));
        blocks.push_back(random_values(random, kind, 50, 70));
        blocks.back()[3] = low / steps(kind), blocks.back()[7] = blocks.back()[8] = high / steps(kind);
    }
    return blocks;
}

void expect_ramp(int first, int second, RgtcKind kind, std::array<double, 8> expected) {
    const std::array<double, 8> ramp = rgtc_ramp(first, second, kind);
    for (size_t i = 0; i < 8; ++i)
        EXPECT_NEAR(ramp[i] * steps(kind), expected[i], 1e-12) << first << ", " << second << ": index " << i;
}

// Appendix C.1 of OpenGL 4.1. The ends are 140 or 100 apart, so that a step is 20.
TEST(Rgtc, DecodesTheRampsOfTheSpecification) {
    expect_ramp(200, 60, unorm, {200, 60, 180, 160, 140, 120, 100, 80});  // (6 * 200 + 60) / 7 = 180
    expect_ramp(60, 160, unorm, {60, 160, 80, 100, 120, 140, 0, 255});    // (4 * 60 + 160) / 5 = 80
    expect_ramp(100, -40, snorm, {100, -40, 80, 60, 40, 20, 0, -20});
    expect_ramp(-40, 60, snorm, {-40, 60, -20, 0, 20, 40, -127, 127});
    expect_ramp(77, 77, unorm, {77, 77, 77, 77, 77, 77, 0, 255});  // equal ends have the ramp of 6 values
    expect_ramp(7, -128, snorm, {7, -127, -85 / 7., -219 / 7., -353 / 7., -487 / 7., -621 / 7., -755 / 7.});
}

TEST(Rgtc, ReadsThreeBitsATexelFromTheLowestBitOn) {
    // Texel i has the index i mod 8. Eight indices are the octal number 76543210, which is FAC688 in hexadecimal.
    const std::array<uint8_t, 8> bytes = {200, 60, 0x88, 0xC6, 0xFA, 0x88, 0xC6, 0xFA};
    const RgtcBlock block = rgtc_block(bytes, unorm);
    EXPECT_EQ(block.first, 200);
    EXPECT_EQ(block.second, 60);
    for (int i = 0; i < 16; ++i) EXPECT_EQ(block.indices[size_t(i)], i % 8);
    EXPECT_EQ(rgtc_bytes(block), bytes);
    const RgtcBlock of_signed = rgtc_block({0x64, 0xD8, 0, 0, 0, 0, 0, 0xE0}, snorm);
    EXPECT_EQ(of_signed.first, 100);
    EXPECT_EQ(of_signed.second, -40);  // 0xD8 = 216 = 256 - 40
    EXPECT_EQ(of_signed.indices[15], 7);
    EXPECT_NEAR(rgtc_decode(of_signed, snorm)[15] * 127, -20, 1e-12);
}

TEST(Rgtc, ABlockOfOneValueIsItsNearestStep) {
    for (const RgtcKind kind : kinds) {
        Values values;
        values.fill(100.3 / steps(kind));
        const RgtcBlock fit = rgtc_range_fit(values, kind);
        EXPECT_EQ(fit.first, 100);
        for (const double value : rgtc_decode(fit, kind)) EXPECT_NEAR(value, 100 / steps(kind), 1e-15);
        // The best block is nearer, by a value between two steps: (5 * 102 + 2 * 96) / 7 = 100.286.
        EXPECT_LE(squared(rgtc_best, values, kind), 16 * std::pow((100.3 - 702 / 7.) / steps(kind), 2) + 1e-15);
    }
}

TEST(Rgtc, ABlockOfTwoValuesHasNoErrorButRounding) {
    Values values;
    for (size_t i = 0; i < 16; ++i) values[i] = (i % 3 == 0 ? 20.0 : 90.0) / 255;
    EXPECT_EQ(squared(rgtc_range_fit, values, unorm), 0);
    for (double& value : values) value += 0.4 / 255;
    EXPECT_NEAR(squared(rgtc_range_fit, values, unorm), 16 * std::pow(0.4 / 255, 2), 1e-12);
}

TEST(Rgtc, ARampIsWithinHalfAStepOfItsEightValues) {
    for (const RgtcKind kind : kinds) {
        Values values;
        for (size_t i = 0; i < 16; ++i) values[i] = 7.0 * double(i) / steps(kind);  // 0 to 105: steps of 15
        const Values decoded = rgtc_decode(rgtc_range_fit(values, kind), kind);
        for (size_t i = 0; i < 16; ++i) EXPECT_LE(std::abs(decoded[i] - values[i]), 7.5 / steps(kind) + 1e-12);
        Values coarse;
        for (size_t i = 0; i < 16; ++i) coarse[i] = 15.0 * double(i / 2) / steps(kind);
        EXPECT_LT(squared(rgtc_range_fit, coarse, kind), 1e-25);
    }
}

TEST(Rgtc, TheBestBlockUsesBothModes) {
    Values values;
    for (size_t i = 0; i < 16; ++i) values[i] = double(100 + i % 6) / 255;
    values[3] = 0, values[9] = 1;
    const RgtcBlock best = rgtc_best(values, unorm);
    EXPECT_LE(best.first, best.second);
    EXPECT_LT(rgtc_squared_error(best, values, unorm), 1e-25);
    EXPECT_GT(squared(rgtc_range_fit, values, unorm), 16 * std::pow(1 / 255.0, 2));
}

// The search covers all 256 x 256 pairs of ends, so no other ends can be better: random ones, those of the range in
// both orders, or the best ones moved by a step.
TEST(Rgtc, NoEncoderBeatsTheBestBlock) {
    std::mt19937 random(4);
    for (const RgtcKind kind : kinds) {
        const int low = kind == unorm ? 0 : -127, high = kind == unorm ? 255 : 127;
        std::uniform_int_distribution<> end(low, high);
        for (const Values& values : blocks_of(kind)) {
            const RgtcBlock best = rgtc_best(values, kind);
            const double least = rgtc_squared_error(best, values, kind);
            const auto expect_no_better = [&](int first, int second) {
                first = std::clamp(first, low, high), second = std::clamp(second, low, high);
                const std::array<double, 8> ramp = rgtc_ramp(first, second, kind);
                double error = 0;
                for (const double value : values) {
                    double nearest = std::numeric_limits<double>::infinity();
                    for (const double other : ramp) nearest = std::min(nearest, std::pow(other - value, 2));
                    error += nearest;
                }
                EXPECT_GE(error, least - 1e-15) << first << ", " << second;
            };
            const RgtcBlock fit = rgtc_range_fit(values, kind);
            for (int i = -8; i <= 8; ++i)
                for (int j = -8; j <= 8; ++j) {
                    expect_no_better(fit.first + i, fit.second + j);
                    expect_no_better(fit.second + i, fit.first + j);
                    expect_no_better(best.first + i, best.second + j);
                }
            for (int i = 0; i < 5000; ++i) expect_no_better(end(random), end(random));
        }
    }
}

TEST(Rgtc, RefusesNaNAndClampsTheRest) {
    Values values{};
    values[5] = std::nan("");
    EXPECT_THROW(rgtc_range_fit(values, unorm), Error);
    EXPECT_THROW(rgtc_best(values, snorm), Error);
    values[5] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(rgtc_range_fit(values, snorm).first, 127);
}

}  // namespace
}  // namespace relief
