// Lab 02: each format against its codec in double precision, and against published errors.
#include "tests/labs/shots.h"

namespace relief {
namespace {

constexpr const char* formats[] = {"unorm8", "unorm8-truncated", "snorm8", "paired8", "rg8", "rg16", "oct16", "half"};
std::vector<Knob> one(const char* format) { return {{"view", "one"}, {"format", format}}; }

TEST(NormalMapStorage, EveryFormatMatchesDoublePrecision) {
    for (const char* format : formats) {
        const ErrorSummary off = error_of("02", shot_of("02", one(format), "stored"));
        EXPECT_GT(off.count, 4000u) << format;
        // A direction in single precision sometimes falls on the other side of a tie. With 16-bit codes this is more
        // frequent, because their steps are closer to the rounding of floats.
        EXPECT_LT(off.mean, std::string(format) == "rg16" ? 0.05 : 0.01) << format;
    }
}

/// Returns the mean error over the whole sphere, seen from six sides. Many pixels share a code, so that the pixel grid
/// does not align with the grid of codes.
double mean_error(std::vector<Knob> knobs) {
    double sum = 0;
    for (const auto& [yaw, pitch] : {std::pair(0, 0), {90, 0}, {180, 0}, {270, 0}, {0, 89}, {0, -89}}) {
        Shot shot = shot_of("02", knobs, "normal");
        shot.camera.yaw = yaw, shot.camera.pitch = pitch, shot.size = {331, 331};
        sum += error_of("02", shot).mean / 6;
    }
    return sum;
}

TEST(NormalMapStorage, TruncatingAndAMismatchedDecoderEachDoubleTheError) {
    EXPECT_NEAR(mean_error(one("unorm8")), 0.170, 0.003);  // Cigolle et al. 2014
    EXPECT_NEAR(mean_error(one("unorm8-truncated")), 0.339, 0.01);
    std::vector<Knob> mismatch = one("paired8");
    mismatch.emplace_back("mismatch", "on");
    EXPECT_NEAR(mean_error(mismatch), 0.340, 0.01);
    EXPECT_NEAR(mean_error(one("oct16")), 0.337, 0.01);  // Cigolle et al. 2014
}

TEST(NormalMapStorage, TwoChannelsShowNoSurfaceBelowTheHorizon) {
    Shot shot = shot_of("02", one("rg8"), "normal");
    shot.camera.yaw = 180, shot.camera.pitch = 60;
    const Image normal = drawn("02", shot);
    for (size_t i = 0; i < normal.pixel_count(); ++i)
        ASSERT_TRUE(normal.values[i * 4] == no_surface || normal.values[i * 4 + 2] >= 0);
}

}  // namespace
}  // namespace relief
